#include "http/target.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace tuftwave::server {
namespace {

bool is_visible(const char c) { return c > ' ' && c < '\x7f'; }

std::optional<std::string> decoded(const std::string_view text, const bool plus_is_space) {
    std::string out;
    out.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '+' && plus_is_space) {
            out += ' ';
        } else if (text[i] != '%') {
            out += text[i];
        } else {
            const std::string_view digits = text.substr(i + 1, 2);
            unsigned char byte = 0;
            const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
            if (error != std::errc{} || digits.size() != 2 || end != digits.data() + 2) return {};
            out += static_cast<char>(byte);
            i += 2;
        }
    }
    return out;
}

/// What stands before the separator; `text` keeps what stands behind it.
std::string_view cut(std::string_view& text, const char separator) {
    const std::size_t end = text.find(separator);
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return part;
}

}  // namespace

std::optional<Target> parse_target(std::string_view target) {
    if (!target.starts_with('/') || target.find('#') != std::string_view::npos) return {};
    if (!std::all_of(target.begin(), target.end(), is_visible)) return {};
    std::optional<std::string> path = decoded(cut(target, '?'), false);
    if (!path || path->find('\0') != std::string::npos) return {};
    Target parsed{*std::move(path), {}};
    while (!target.empty()) {
        std::string_view value = cut(target, '&');
        if (value.empty()) continue;
        std::optional<std::string> name = decoded(cut(value, '='), true);
        std::optional<std::string> decoded_value = decoded(value, true);
        if (!name || !decoded_value) return {};
        parsed.query.emplace_back(*std::move(name), *std::move(decoded_value));
    }
    return parsed;
}

}  // namespace tuftwave::server
