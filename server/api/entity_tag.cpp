#include "api/entity_tag.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace tuftwave::server {
namespace {

static_assert(std::endian::native == std::endian::little, "or replicas would give different tags");

/// A hash of the exact bytes, as FNV-1a but eight at a time, since a page's files are large.
std::string entity_tag(const std::string_view body) {
    std::uint64_t hash = 0xcbf29ce484222325;
    const auto take = [&hash](const std::uint64_t word) {
        hash = (hash ^ word) * 0x100000001b3;
        hash ^= hash >> 32;
    };
    for (std::size_t at = 0; at < body.size(); at += sizeof hash) {
        std::uint64_t word = 0;
        std::memcpy(&word, body.data() + at, std::min(sizeof word, body.size() - at));
        take(word);
    }
    take(body.size());  // zeros at its end count, too
    char digits[17] = {};
    const auto end = std::to_chars(digits, digits + 16, hash, 16).ptr;
    return "\"" + std::string(digits, end) + "\"";
}

/// By where the bytes are, since they stay there: there are as many as the program has files.
const std::string& tag_of_constant(const std::string_view constant) {
    static std::mutex mutex;
    static std::map<std::pair<const char*, std::size_t>, std::string> tags;
    const std::lock_guard lock(mutex);
    std::string& tag = tags[{constant.data(), constant.size()}];
    if (tag.empty()) tag = entity_tag(constant);
    return tag;
}

}  // namespace

Response with_entity_tag(Response response, const Request& request) {
    const std::string tag =
        response.constant.empty() ? entity_tag(response.content()) : tag_of_constant(response.constant);
    const std::string& if_none_match = request.header("if-none-match");
    response.headers.emplace_back("ETag", tag);
    if (if_none_match.find(tag) != std::string::npos || if_none_match == "*") {
        response.status = 304;
        response.body.clear();
        response.first = 0;
        response.constant = {};
    }
    return response;
}

}  // namespace tuftwave::server
