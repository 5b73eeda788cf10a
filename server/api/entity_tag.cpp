#include "api/entity_tag.hpp"

#include <charconv>
#include <cstdint>

namespace tuftwave::server {
namespace {

/// FNV-1a of the exact bytes.
std::string entity_tag(const std::string& body) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : body) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    char digits[17] = {};
    const auto end = std::to_chars(digits, digits + 16, hash, 16).ptr;
    return "\"" + std::string(digits, end) + "\"";
}

}  // namespace

Response with_entity_tag(Response response, const Request& request) {
    const std::string tag = entity_tag(response.body);
    const std::string& if_none_match = request.header("if-none-match");
    response.headers.emplace_back("ETag", tag);
    if (if_none_match.find(tag) != std::string::npos || if_none_match == "*") {
        response.status = 304;
        response.body.clear();
    }
    return response;
}

}  // namespace tuftwave::server
