#include "sound_answer.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <variant>

#include "character/glb.hpp"

namespace tuftwave::server::fuzz {
namespace {

using nlohmann::json;

constexpr std::string_view kXdtsLine = "exchangeDigitalTimeSheet Save Data\n";
constexpr std::size_t kVmdHead = 54, kVmdKey = 111, kVmdTail = 20, kMostErrors = 16;

bool is_pointer(const std::string& text) {
    if (text.empty() || text.front() == '?') return true;
    try {
        return !json::json_pointer(text).empty();
    } catch (const json::parse_error&) {
        return false;
    }
}

std::string fault_of_error(const json& error, const std::string& type) {
    for (const char* const name : {"code", "pointer", "detail"}) {
        if (!error.contains(name) || !error[name].is_string()) return std::string("an error without ") + name;
    }
    if (!is_pointer(error["pointer"])) return "no JSON pointer: " + error["pointer"].dump();
    return type.empty() || type == "urn:tuftwave:problem:" + error["code"].get<std::string>()
               ? ""
               : "the first error does not name the problem";
}

std::string fault_of_problem(const Problem& problem) {
    const Response response = to_response(problem, "id");
    if (response.status < 400 || response.status >= 500) return "status " + std::to_string(response.status);
    const json body = json::parse(response.body, nullptr, false);
    if (!body.is_object()) return "a problem that is no JSON";
    if (body["status"] != response.status || !body["detail"].is_string()) return "a problem with another status";
    if (!body.contains("errors")) return problem.fields.empty() ? "" : "errors are left out";
    if (body["errors"].size() > kMostErrors) return "too many errors";
    std::string type = body["type"];
    for (const json& error : body["errors"]) {
        if (const std::string fault = fault_of_error(error, type); !fault.empty()) return fault;
        type.clear();
    }
    return "";
}

bool is_glb(const std::string& body) {
    const auto parts = character::split_glb(body);
    const auto* glb = std::get_if<character::Glb>(&parts);
    return glb != nullptr && json::accept(glb->json);
}

bool is_vmd(const std::string& body) {
    if (!body.starts_with("Vocaloid Motion Data 0002") || body.size() < kVmdHead + kVmdTail) return false;
    std::size_t keys = 0;
    for (std::size_t i = 4; i-- > 0;) keys = keys << 8 | static_cast<unsigned char>(body[50 + i]);
    return body.size() == kVmdHead + keys * kVmdKey + kVmdTail;
}

bool is_as_it_says(const Response& response) {
    const std::string body(response.content());
    const std::string type = response.content_type.substr(0, response.content_type.find(';'));
    if (type == "application/json" || type == "model/gltf+json") return json::accept(body);
    if (type == "model/gltf-binary") return is_glb(body);
    if (type == "application/x-xdts+json")
        return body.starts_with(kXdtsLine) && json::accept(std::string_view(body).substr(kXdtsLine.size()));
    if (type == "text/csv") return body.starts_with("frame,picture,key\r\n") && body.ends_with("\r\n");
    if (type == "application/octet-stream") return is_vmd(body);
    if (type == "application/x-bvh") return body.starts_with("HIERARCHY\nROOT hair_root\n{\n");
    if (type == "model/vnd.usda")
        return body.starts_with("#usda 1.0\n") && std::ranges::count(body, '{') == std::ranges::count(body, '}');
    return false;
}

}  // namespace

std::string fault_of(const Answer& answer) {
    if (const auto* problem = std::get_if<Problem>(&answer)) return fault_of_problem(*problem);
    const auto& response = std::get<Response>(answer);
    if (response.status != 200) return "status " + std::to_string(response.status);
    return is_as_it_says(response) ? "" : "the body is no " + response.content_type;
}

}  // namespace tuftwave::server::fuzz
