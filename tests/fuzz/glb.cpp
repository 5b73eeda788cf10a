#include "character/glb.hpp"

#include <nlohmann/json.hpp>
#include <variant>

#include "api/character_chains.hpp"
#include "api/character_motion.hpp"
#include "fuzz_limits.hpp"
#include "sound_answer.hpp"
#include "targets.hpp"

namespace tuftwave::server::fuzz {
namespace {

using nlohmann::json;

Request posted(const std::string_view file) {
    return {"POST", "", {}, {{"content-type", "model/gltf-binary"}}, std::string(file)};
}

/// What is padded here begins with what was there.
bool is_padded(const std::string_view padded, const std::string_view part) {
    return padded.starts_with(part) && padded.size() - part.size() < 4;
}

void require_same_parts(const character::Glb& glb) {
    const std::string file = character::join_glb(glb.json, glb.binary, "", glb.others);
    const auto again = character::split_glb(file);
    const auto* parts = std::get_if<character::Glb>(&again);
    require(parts != nullptr, "what is put together comes apart again");
    require(is_padded(parts->json, glb.json), "the JSON stays");
    require(is_padded(parts->binary, glb.binary), "the binary chunk stays");
    require(parts->others == glb.others, "other chunks stay");
}

/// The names of the chains that a file is found to have.
json chains_of(const std::string& file, const Limits& limits) {
    const Answer answer = post_character_chains(posted(file), {limits, InOrder(), {}});
    const std::string fault = fault_of(answer);
    require(fault.empty(), fault);
    json names = json::array();
    if (const auto* response = std::get_if<Response>(&answer)) {
        const json body = json::parse(response->body);
        for (const json& chain : body["chains"]) names.push_back(chain["name"]);
    }
    return names;
}

/// The file with its clip has the same chains, its old bytes, and one animation more.
void require_only_a_clip_more(const std::string_view before, const std::string& after, const Limits& limits) {
    const auto old_parts = character::split_glb(before), new_parts = character::split_glb(after);
    const auto& old_glb = std::get<character::Glb>(old_parts);
    require(std::holds_alternative<character::Glb>(new_parts), "the answer is a GLB");
    const auto& new_glb = std::get<character::Glb>(new_parts);
    require(new_glb.binary.starts_with(old_glb.binary), "the binary chunk stays");
    require(new_glb.others == old_glb.others, "other chunks stay");
    const json old_json = json::parse(old_glb.json), new_json = json::parse(new_glb.json);
    const std::size_t animations = old_json.contains("animations") ? old_json["animations"].size() : 0;
    require(new_json["animations"].size() == animations + 1, "there is one animation more");
    require(chains_of(std::string(before), limits) == chains_of(after, limits), "the chains stay");
}

}  // namespace

void run_glb(const Target&, const std::string_view input) {
    static const Limits limits = small_limits();
    const auto parts = character::split_glb(input);
    if (const auto* glb = std::get_if<character::Glb>(&parts)) require_same_parts(*glb);
    Request request = posted(input);
    request.query = {{"chains", "*"}};
    const Answer answer = post_character_motion(request, {limits, InOrder(), {}});
    const std::string fault = fault_of(answer);
    require(fault.empty(), fault);
    if (const auto* response = std::get_if<Response>(&answer)) require_only_a_clip_more(input, response->body, limits);
}

}  // namespace tuftwave::server::fuzz
