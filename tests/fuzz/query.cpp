#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "api/formats.hpp"
#include "api/routes.hpp"
#include "fuzz_limits.hpp"
#include "http/target.hpp"
#include "sound_answer.hpp"
#include "targets.hpp"

namespace tuftwave::server::fuzz {
namespace {

/// Every byte as %xx, so that nothing in it can be taken for something else.
std::string encoded(const std::string& text) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        out += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
    return out;
}

std::string written(const server::Target& target) {
    std::string text = "/" + encoded(target.path.substr(1));
    char separator = '?';
    for (const auto& [name, value] : target.query) {
        text += separator + encoded(name) + "=" + encoded(value);
        separator = '&';
    }
    return text;
}

}  // namespace

/// A request's target, as sent; what it says is then asked of the one operation that is nothing but its query.
void run_query(const Target&, const std::string_view input) {
    static const Limits limits = small_limits();
    const auto target = parse_target(input);
    if (!target) return;
    require(target->path.starts_with('/'), "a path begins with a slash");
    const auto again = parse_target(written(*target));
    require(again.has_value(), "what is written anew is read again");
    require(again->path == target->path && again->query == target->query, "it says the same");
    const Request request{"GET", "/v1/schedules", target->query, {{"accept", target->path.substr(1)}}, ""};
    const Route& route = *std::get<const Route*>(find_route("GET", "/v1/schedules"));
    const std::string fault = fault_of(route.run(request, {limits, InOrder(), {}}));
    require(fault.empty(), fault);
}

}  // namespace tuftwave::server::fuzz
