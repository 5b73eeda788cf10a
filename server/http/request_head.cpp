#include "http/request_head.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <utility>

#include "http/target.hpp"

namespace tuftwave::server {
namespace {

constexpr std::array<std::string_view, 4> kMethods{"GET", "HEAD", "POST", "OPTIONS"};
constexpr std::size_t kMostLengthDigits = 19;  // what 64 bits hold for sure

struct FirstLine {
    std::string_view method, target, version;
};

bool is_letter_or_digit(const char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_token(const std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](const char c) {
        return is_letter_or_digit(c) || c == '-' ||
               std::string_view("!#$%&'*+.^_`|~").find(c) != std::string_view::npos;
    });
}

/// Visible ASCII, space, tab, and bytes above ASCII: what a header may have (RFC 9110, section 5.5).
bool is_value(const std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](const char c) {
        return (c >= ' ' && c != '\x7f') || c == '\t' || static_cast<signed char>(c) < 0;
    });
}

/// A host with or without a port: nothing that could be taken for a path, a user or a list.
bool is_host(const std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](const char c) {
        return is_letter_or_digit(c) || c == '.' ||
               std::string_view("-_~!$&'()*+;=:[]%").find(c) != std::string_view::npos;
    });
}

std::string lower(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    return out;
}

bool is_all_digits(const std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](const char c) { return c >= '0' && c <= '9'; });
}

/// METHOD SP target SP HTTP/d.d
std::optional<FirstLine> split_first_line(const std::string_view line) {
    const std::size_t first = line.find(' '), last = line.rfind(' ');
    if (first == std::string_view::npos || first == last) return {};
    const FirstLine parts{line.substr(0, first), line.substr(first + 1, last - first - 1), line.substr(last + 1)};
    const bool has_version = parts.version.size() == 8 && parts.version.starts_with("HTTP/") &&
                             parts.version[6] == '.' && is_all_digits(parts.version.substr(5, 1)) &&
                             is_all_digits(parts.version.substr(7));
    if (!is_token(parts.method) || parts.target.empty() || !has_version) return {};
    if (parts.target.find(' ') != std::string_view::npos) return {};
    return parts;
}

std::string_view trimmed(std::string_view text) {
    const auto is_space = [](const char c) { return c == ' ' || c == '\t'; };
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    return text;
}

/// name:value. A line that begins with a space would continue the one before; it has no name, and is refused.
bool read_header(const std::string_view line, NameValues& to) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || !is_token(line.substr(0, colon))) return false;
    const std::string_view value = trimmed(line.substr(colon + 1));
    if (!is_value(value)) return false;
    to.emplace_back(lower(line.substr(0, colon)), std::string(value));
    return true;
}

auto count_of(const NameValues& headers, const std::string_view name) {
    return std::count_if(headers.begin(), headers.end(), [&](const auto& header) { return header.first == name; });
}

/// Whether a header's comma-separated lists name an option, in any case.
bool lists(const NameValues& headers, const std::string_view name, const std::string_view option) {
    for (const auto& [key, value] : headers) {
        if (key != name) continue;
        for (std::string_view rest = value; !rest.empty();) {
            const std::size_t comma = rest.find(',');
            if (lower(trimmed(rest.substr(0, comma))) == option) return true;
            rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
        }
    }
    return false;
}

int fault_of_host(const RequestHead& head) {
    const auto hosts = count_of(head.request.headers, "host");
    const bool is_sound = hosts == 1 || (hosts == 0 && head.is_http_1_0);
    return is_sound && is_host(head.request.header("host")) ? 0 : 400;
}

/// Where the body ends (RFC 9112, section 6.3), or the status that refuses the request.
int read_framing(RequestHead& head) {
    const NameValues& headers = head.request.headers;
    const auto lengths = count_of(headers, "content-length"), codings = count_of(headers, "transfer-encoding");
    if (lengths + codings > 1) return 400;
    if (codings == 1) {
        if (head.is_http_1_0 || lower(head.request.header("transfer-encoding")) != "chunked") return 400;
        head.is_chunked = true;
    }
    if (lengths == 1) {
        const std::string& digits = head.request.header("content-length");
        if (!is_all_digits(digits)) return 400;
        if (digits.size() > kMostLengthDigits) return 413;
        std::from_chars(digits.data(), digits.data() + digits.size(), head.length);
    }
    if (head.request.method != "POST") return head.has_body() ? 400 : 0;
    return lengths + codings == 0 ? 411 : 0;
}

int read_expectations(RequestHead& head) {
    // Unpacking what a client packed is how half a megabyte becomes five hundred.
    for (const auto& [name, value] : head.request.headers) {
        if (name == "content-encoding" && lower(value) != "identity" && !value.empty()) return 415;
        if (name == "expect" && lower(value) != "100-continue") return 417;
        head.expects_continue |= name == "expect" && !head.is_http_1_0;
    }
    head.wants_close = head.is_http_1_0 || lists(head.request.headers, "connection", "close");
    return 0;
}

int read_headers(std::string_view text, RequestHead& head) {
    while (!text.starts_with("\r\n")) {
        const std::size_t end = text.find("\r\n");
        if (head.request.headers.size() == kMostHeaders) return 431;
        if (!read_header(text.substr(0, end), head.request.headers)) return 400;
        text.remove_prefix(end + 2);
    }
    return 0;
}

int read_first_line(const std::string_view line, RequestHead& head) {
    const std::optional<FirstLine> parts = split_first_line(line);
    if (!parts) return 400;
    if (parts->version != "HTTP/1.1" && parts->version != "HTTP/1.0") return 505;
    if (std::find(kMethods.begin(), kMethods.end(), parts->method) == kMethods.end()) return 501;
    if (parts->target.size() > kMostTargetBytes) return 414;
    std::optional<Target> target = parse_target(parts->target);
    if (!target) return 400;
    head.is_http_1_0 = parts->version == "HTTP/1.0";
    head.request.method = parts->method;
    head.request.path = std::move(target->path);
    head.request.query = std::move(target->query);
    return 0;
}

}  // namespace

int fault_of_first_line(const std::string_view line) {
    RequestHead head;
    return read_first_line(line, head);
}

RequestHead parse_head(const std::string_view text) {
    RequestHead head;
    const std::size_t end = text.find("\r\n");
    head.fault = read_first_line(text.substr(0, end), head);
    if (head.fault != 0) return head;
    head.fault = read_headers(text.substr(end + 2), head);
    if (head.fault == 0) head.fault = fault_of_host(head);
    if (head.fault == 0) head.fault = read_framing(head);
    if (head.fault == 0) head.fault = read_expectations(head);
    return head;
}

}  // namespace tuftwave::server
