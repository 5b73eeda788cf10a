#include "access/origins.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace tuftwave::server {
namespace {

constexpr const char* kRequestHeaders = "Authorization, Content-Type, Accept, If-None-Match";
constexpr const char* kAnswerHeaders =
    "ETag, Retry-After, Content-Disposition, Request-Id, Tuftwave-Frame-Rate, Allow, Accept, WWW-Authenticate";
constexpr const char* kMaxAge = "7200";  // seconds; browsers keep it no longer

bool is_all_of(const std::string_view text, const std::string_view letters) {
    return !text.empty() && text.find_first_not_of(letters) == std::string_view::npos;
}

bool is_host(const std::string_view host) {
    if (host.starts_with('['))
        return host.ends_with(']') && is_all_of(host.substr(1, host.size() - 2), "0123456789abcdef:.");
    return is_all_of(host, "abcdefghijklmnopqrstuvwxyz0123456789-.");
}

/// A port as browsers write it: without zeros before, and none where it is the scheme's own.
bool is_port(const std::string_view port, const bool is_https) {
    int number = 0;
    const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), number);
    return error == std::errc{} && end == port.data() + port.size() && std::to_string(number) == port && number >= 1 &&
           number <= 65'535 && number != (is_https ? 443 : 80);
}

/// Whether a browser could send it, letter by letter.
bool is_origin(std::string_view text) {
    const bool is_https = text.starts_with("https://");
    if (!is_https && !text.starts_with("http://")) return false;
    text.remove_prefix(is_https ? 8 : 7);
    const std::size_t bracket = text.find(']');
    const std::size_t colon = text.find(':', bracket == std::string_view::npos ? 0 : bracket);
    if (colon != std::string_view::npos && !is_port(text.substr(colon + 1), is_https)) return false;
    return is_host(text.substr(0, colon));
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// One Vary header, whatever the answer varies by already.
void vary_by_origin(NameValues& headers) {
    for (auto& [name, value] : headers) {
        if (name != "Vary") continue;
        value += ", Origin";
        return;
    }
    headers.emplace_back("Vary", "Origin");
}

}  // namespace

std::variant<Origins, std::string> Origins::parse(const std::string& list) {
    Origins made;
    std::string_view rest = list;
    if (trimmed(rest).empty()) return made;
    for (bool is_last = false; !is_last;) {
        const std::size_t end = rest.find(',');
        const std::string_view origin = trimmed(rest.substr(0, end));
        if (!is_origin(origin))
            return "option origins: number " + std::to_string(made.origins_.size() + 1) +
                   " is not an origin as browsers send it: https://studio.example or http://localhost:5173, in small "
                   "letters, without a path, a wildcard or the scheme's own port";
        made.origins_.emplace_back(origin);
        is_last = end == std::string_view::npos;
        if (!is_last) rest.remove_prefix(end + 1);
    }
    return made;
}

bool Origins::is_preflight(const Request& request) const {
    return is_on() && request.method == "OPTIONS" && !request.header("origin").empty() &&
           !request.header("access-control-request-method").empty();
}

Response Origins::preflight(const Request& request, const std::string& allow) const {
    Response response{204, "", "", {{"Allow", allow}, {"Vary", "Origin"}}};
    const std::string origin = listed_origin(request);
    if (origin.empty()) return response;
    response.headers.emplace_back("Access-Control-Allow-Origin", origin);
    response.headers.emplace_back("Access-Control-Allow-Methods", allow);
    response.headers.emplace_back("Access-Control-Allow-Headers", kRequestHeaders);
    response.headers.emplace_back("Access-Control-Max-Age", kMaxAge);
    return response;
}

void Origins::add_headers(const Request& request, Response& response) const {
    if (!is_on() || is_preflight(request)) return;  // a browser refuses an answer that names its origin twice
    vary_by_origin(response.headers);
    const std::string origin = listed_origin(request);
    if (origin.empty()) return;
    response.headers.emplace_back("Access-Control-Allow-Origin", origin);
    response.headers.emplace_back("Access-Control-Expose-Headers", kAnswerHeaders);
}

std::string Origins::listed_origin(const Request& request) const {
    const auto is_origin_header = [](const auto& header) { return header.first == "origin"; };
    if (std::count_if(request.headers.begin(), request.headers.end(), is_origin_header) != 1) return "";
    const std::string& origin = request.header("origin");
    return std::find(origins_.begin(), origins_.end(), origin) == origins_.end() ? "" : origin;
}

}  // namespace tuftwave::server
