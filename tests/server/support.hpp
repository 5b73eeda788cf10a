#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "api/json_guard.hpp"
#include "api/operation.hpp"
#include "api/problem.hpp"
#include "api/routes.hpp"

namespace tuftwave::server {

/// A hairstyle of one tuft with the paper's timing: the smallest that has a mesh, a skin and a clip.
inline nlohmann::json small_hairstyle() {
    return nlohmann::json::parse(R"({
        "head": {"center": [0, 0, 0]},
        "tufts": [{"name": "fringe", "points": [[0, 0.1, 0.02], [0.02, 0.09, 0.09], [0.03, 0.02, 0.12]]}],
        "motion": {"timing": {"period": 0.45, "fps": 24, "hold": 2}}
    })");
}

inline Request json_post(const std::string& path, const std::string& body, const std::string& accept = "") {
    return {"POST", path, {}, {{"content-type", "application/json"}, {"accept", accept}}, body};
}

/// What can be looked at of a text that is JSON.
inline JsonDocument parsed(const std::string& text) { return std::get<JsonDocument>(parse_guarded(text, {})); }

/// The same value as one of the other library.
inline nlohmann::json as_plain(const JsonValue value) {
    nlohmann::json plain;
    if (value.is_array()) {
        plain = nlohmann::json::array();
        for (const JsonValue item : value.items()) plain.push_back(as_plain(item));
    }
    if (value.is_object()) {
        plain = nlohmann::json::object();
        for (const auto& [key, member] : value.members()) plain[std::string(key)] = as_plain(member);
    }
    if (const auto number = value.number()) plain = *number;
    if (const auto flag = value.boolean()) plain = *flag;
    if (const auto text = value.text()) plain = *text;
    return plain;
}

/// Runs a request's operation on the calling thread, without a service.
inline Answer answer_to(const Request& request, std::stop_token stop = {}) {
    const auto found = find_route(request.method, request.path);
    if (const auto* problem = std::get_if<Problem>(&found)) return *problem;
    static const Limits limits;
    return std::get<const Route*>(found)->run(request, {limits, InOrder(), std::move(stop)});
}

/// The JSON chunk of a GLB.
inline nlohmann::json glb_json(const std::string& glb) {
    const auto byte = [&](std::size_t at) { return static_cast<std::size_t>(static_cast<unsigned char>(glb.at(at))); };
    const std::size_t length = byte(12) | byte(13) << 8 | byte(14) << 16 | byte(15) << 24;
    return nlohmann::json::parse(glb.substr(20, length));
}

inline std::string slug_of(const Answer& answer) {
    const auto* problem = std::get_if<Problem>(&answer);
    return problem == nullptr ? "no problem" : slug(problem->code);
}

inline std::string pointer_of(const Answer& answer) {
    const auto* problem = std::get_if<Problem>(&answer);
    return problem == nullptr || problem->fields.empty() ? "no field" : problem->fields.front().pointer;
}

}  // namespace tuftwave::server
