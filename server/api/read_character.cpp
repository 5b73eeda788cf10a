#include "api/read_character.hpp"

#include <nlohmann/json.hpp>

#include "api/body.hpp"
#include "api/json_guard.hpp"
#include "character/file_limits.hpp"

namespace tuftwave::server {
namespace {

/// What the JSON of a file may be. A face with many expressions nests deeper and has longer lists than what we ask for.
constexpr JsonLimits kFileJson{character::kFileLimits.json_bytes,
                               character::kFileLimits.json_depth,
                               character::kFileLimits.json_values,
                               character::kFileLimits.keys_per_object,
                               true,
                               character::kFileLimits.json_memory};

ProblemCode code_of(character::Fault::Kind kind) {
    using Kind = character::Fault::Kind;
    switch (kind) {
        case Kind::kMalformed:
            return ProblemCode::kMalformed;
        case Kind::kMissing:
            return ProblemCode::kMissingField;
        case Kind::kWrongType:
            return ProblemCode::kWrongType;
        case Kind::kOutOfRange:
            return ProblemCode::kOutOfRange;
        case Kind::kTooMany:
            return ProblemCode::kTooMany;
        case Kind::kConflict:
            return ProblemCode::kConflict;
        case Kind::kDegenerate:
            return ProblemCode::kDegenerate;
        case Kind::kUnsupported:
            return ProblemCode::kUnsupported;
    }
    return ProblemCode::kInternal;
}

}  // namespace

Problem to_problem(const character::Fault& fault) {
    if (fault.kind == character::Fault::Kind::kMalformed) return {ProblemCode::kMalformed, fault.allowed, {}, {}};
    return fields_problem(
        {{code_of(fault.kind), fault.pointer, fault.given, fault.allowed, fault.minimum, fault.maximum}});
}

std::variant<Upload, Problem> read_character(const Request& request, const Limits& limits) {
    if (auto problem = check_media_type(request, {"model/gltf-binary", "model/vrm", "application/octet-stream"}))
        return *std::move(problem);
    Upload upload;
    auto glb = character::split_glb(request.body);
    if (const auto* fault = std::get_if<character::Fault>(&glb)) return to_problem(*fault);
    upload.glb = std::get<character::Glb>(glb);
    auto file = parse_guarded_in_order(upload.glb.json, kFileJson);
    if (auto* problem = std::get_if<Problem>(&file)) return std::move(*problem);
    upload.file = std::get<character::FileJson>(std::move(file));
    auto read = character::read_character(upload.file);
    if (const auto* fault = std::get_if<character::Fault>(&read)) return to_problem(*fault);
    upload.character = std::get<character::Character>(std::move(read));
    const auto own = character::find_own_vertices(upload.file, upload.glb.binary, upload.character, limits.vertices);
    if (const auto* fault = std::get_if<character::Fault>(&own)) return to_problem(*fault);
    upload.found = character::find_chains(upload.character, std::get<std::vector<character::OwnVertices>>(own),
                                          limits.nodes_per_chain);
    return upload;
}

}  // namespace tuftwave::server
