#include "api/routes.hpp"

#include <algorithm>
#include <array>

#include "api/about.hpp"
#include "api/character_chains.hpp"
#include "api/character_motion.hpp"
#include "api/evaluations.hpp"
#include "api/fills.hpp"
#include "api/fits.hpp"
#include "api/hair.hpp"
#include "api/json_guard.hpp"
#include "api/motions.hpp"
#include "api/schedules.hpp"
#include "api/studio.hpp"
#include "character/file_limits.hpp"

namespace tuftwave::server {
namespace {

constexpr std::array<Route, 17> kRoutes{{
    {"POST", "/v1/tufts", post_tufts, true, false, true},
    {"POST", "/v1/fills", post_fills, true},
    {"POST", "/v1/hairstyles", post_hairstyles, true},
    {"POST", "/v1/motions", post_motions, true},
    {"POST", "/v1/characters/chains", post_character_chains, true, true},
    {"POST", "/v1/characters/motion", post_character_motion, true, true},
    {"GET", "/v1/schedules", get_schedules, false},
    {"POST", "/v1/schedules", post_schedules, true, false, true},
    {"POST", "/v1/evaluations", post_evaluations, true},
    {"POST", "/v1/fits", post_fits, true},
    {"GET", "/v1/limits", get_limits, false},
    {"GET", "/v1/version", get_version, false},
    {"GET", "/", get_root, false},
    {"GET", "/openapi.yaml", get_openapi, false},
    {"GET", "/docs", get_docs, false},
    {"GET", "/docs/{file}", get_docs_file, false},
    {"GET", "/studio/{file}", get_studio_file, false},
}};

bool matches(std::string_view pattern, std::string_view path) {
    const std::size_t variable = pattern.find('{');
    if (variable == std::string_view::npos) return pattern == path;
    return path.size() > variable && path.starts_with(pattern.substr(0, variable)) &&
           path.find('/', variable) == std::string_view::npos;
}

}  // namespace

std::span<const Route> routes() { return kRoutes; }

std::size_t body_limit(const std::string& path) {
    const auto takes_file = [&](const Route& route) { return route.takes_file && matches(route.path, path); };
    return std::ranges::any_of(kRoutes, takes_file) ? character::kFileLimits.bytes : JsonLimits{}.bytes;
}

std::string allowed_methods(const std::string& path) {
    std::string allowed;
    for (const Route& route : kRoutes) {
        if (!matches(route.path, path)) continue;
        allowed += (allowed.empty() ? "" : ", ") + std::string(route.method);
        if (route.method == "GET") allowed += ", HEAD";
    }
    return allowed.empty() ? allowed : allowed + ", OPTIONS";
}

std::variant<const Route*, Problem> find_route(const std::string& method, const std::string& path) {
    const std::string_view wanted = method == "HEAD" ? "GET" : std::string_view(method);
    for (const Route& route : kRoutes) {
        if (route.method == wanted && matches(route.path, path)) return &route;
    }
    const std::string allowed = allowed_methods(path);
    if (allowed.empty()) return Problem{ProblemCode::kNotFound, "There is nothing at this path; see /docs.", {}, {}};
    return Problem{ProblemCode::kMethodNotAllowed, "Allowed here: " + allowed + ".", {}, {{"Allow", allowed}}};
}

}  // namespace tuftwave::server
