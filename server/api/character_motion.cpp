#include "api/character_motion.hpp"

#include <nlohmann/json.hpp>
#include <set>

#include "api/body.hpp"
#include "api/character_settings.hpp"
#include "api/choices.hpp"
#include "api/file_options.hpp"
#include "api/formats.hpp"
#include "api/motion_file.hpp"
#include "api/moved_character.hpp"
#include "api/read_character.hpp"
#include "api/write_character.hpp"
#include "api/write_nouns.hpp"
#include "character/clip.hpp"
#include "character/springs.hpp"

namespace tuftwave::server {
namespace {

using Json = nlohmann::ordered_json;

Json warnings(const Upload& upload, const CharacterSettings& settings, const MovedCharacter& moved) {
    Json warnings = warnings_json(&moved.motion.schedule);
    const std::size_t count = character::count_springs(upload.character, moved.found);
    if (settings.springs == Springs::kKeep && count > 0)
        warnings.push_back({{"code", "springs_overwrite"},
                            {"detail", "A VRM player runs its springs after the clip and overwrites it on " +
                                           std::to_string(count) + " of them; springs=remove takes them out."}});
    return warnings;
}

/// All of an answer but its poses.
std::string text_without_poses(const Upload& upload, const CharacterSettings& settings, const MovedCharacter& moved,
                               const Context& context) {
    Json chains = Json::array();
    for (const std::size_t index : moved.indices) chains.push_back(found_chain_json(upload, index));
    return Json{{"facing", upload.character.faces_minus_z ? "-Z" : "+Z"},
                {"schedule", schedule_json(moved.motion.schedule)},
                {"chains", std::move(chains)},
                {"pictures", nullptr},
                {"quality", quality_json(moved.chains, settings.motion.wave, moved.motion, context.stop)},
                {"warnings", warnings(upload, settings, moved)}}
        .dump();
}

std::string poses_json(const Upload& upload, const CharacterSettings& settings, const MovedCharacter& moved,
                       const Context& context) {
    const std::string text = text_without_poses(upload, settings, moved, context);
    const std::vector<ChainPoses> poses =
        character_poses(upload, moved.found, moved.chains, moved.motion, context.stop);
    if (context.stop.stop_requested()) return "";
    return text_with_poses(text, poses, static_cast<std::size_t>(moved.motion.schedule.pictures));
}

/// What the bones are called in the file: tools that have the same model find them by that.
std::variant<poses::BoneNames, Problem> bone_names(const Upload& upload, const MovedCharacter& moved, Format format) {
    poses::BoneNames names;
    std::set<std::string> used;
    for (const character::FoundChain& chain : moved.found) {
        std::vector<std::string>& bones = names.emplace_back();
        for (const int bone : chain.bones) {
            bones.push_back(upload.character.nodes[static_cast<std::size_t>(bone)].name);
            if (!used.insert(bones.back()).second && format == Format::kVmd)
                return fields_problem({{ProblemCode::kConflict,
                                        "?format",
                                        bones.back(),
                                        "another format than vmd, since two of the bones have this name",
                                        {},
                                        {}}});
        }
    }
    return names;
}

/// Chains as a format wants them. In glTF's axes MikuMikuDance's models look to +Z, so others are turned around for it.
std::vector<Chain> facing_as(Format format, const Upload& upload, std::vector<Chain> chains) {
    if (format != Format::kVmd || !upload.character.faces_minus_z) return chains;
    constexpr Quat kHalfTurn{0, 1, 0, 0};
    for (Chain& chain : chains) {
        chain.parent_rotation = kHalfTurn * chain.parent_rotation;
        for (Vec3& node : chain.nodes) node = rotated(kHalfTurn, node);
    }
    return chains;
}

/// A track of the sheet for each kind of chain that moves.
std::vector<std::string> blocks(const MovedCharacter& moved) {
    std::vector<std::string> kinds;
    for (const character::FoundChain& chain : moved.found) kinds.emplace_back(word_of(kKinds, chain.kind));
    return kinds;
}

Answer tool_file(const Upload& upload, const MovedCharacter& moved, Format format, const FileOptions& options,
                 const Context& context) {
    auto names = bone_names(upload, moved, format);
    if (auto* problem = std::get_if<Problem>(&names)) return std::move(*problem);
    const std::vector<Chain> chains = facing_as(format, upload, moved.chains);
    Answer answer = motion_file(
        {chains, moved.motion, "chain", "/chains", "character", blocks(moved), std::get<poses::BoneNames>(names)},
        format, options, context.limits);
    if (auto* problem = std::get_if<Problem>(&answer)) return as_query_problem(std::move(*problem), character_query());
    return answer;
}

/// A clip's JSON has 2.6 KiB for each bone while it is made; characters have some hundreds.
Check check_bones(const MovedCharacter& moved) {
    constexpr std::size_t kMostBones = 16'384;
    std::size_t bones = 0;
    for (const character::FoundChain& chain : moved.found) bones += chain.bones.size();
    return check_total(bones, kMostBones, "bones that the clip moves", "?chains");
}

std::variant<std::string, Problem> file_with_clip(Upload& upload, const CharacterSettings& settings,
                                                  const MovedCharacter& moved, const FileOptions& options) {
    if (const Check wrong = check_bones(moved)) return to_problem(*wrong);
    const std::size_t binary_bytes = upload.glb.binary.size();
    if (const auto fault = character::check_clip_fits(upload.file, settings.clip_name, binary_bytes))
        return to_problem(*fault);
    if (settings.springs == Springs::kRemove) character::remove_springs(upload.file, upload.character, moved.found);
    const std::string added =
        character::add_held_clip(upload.file, upload.character, node_keys(upload, moved),
                                 gltf::clip_keys(moved.motion.schedule, options.holding), settings.clip_name,
                                 schedule_json(moved.motion.schedule), binary_bytes);
    return character::join_glb(upload.file.dump(), upload.glb.binary, added, upload.glb.others);
}

}  // namespace

Answer post_character_motion(const Request& request, const Context& context) {
    if (auto problem = check_query(request, names_of(character_query()))) return *std::move(problem);
    auto chosen = choose_format(
        request, {Format::kGlb, Format::kJson, Format::kXdts, Format::kCsv, Format::kVmd, Format::kBvh, Format::kUsda});
    if (auto* problem = std::get_if<Problem>(&chosen)) return std::move(*problem);
    const Format format = std::get<Format>(chosen);
    auto options = read_file_options(request, format, context.limits);
    if (auto* problem = std::get_if<Problem>(&options)) return std::move(*problem);
    auto read = read_character_settings(request, context.limits);
    if (auto* problem = std::get_if<Problem>(&read)) return std::move(*problem);
    const auto& settings = std::get<CharacterSettings>(read);
    auto posted = read_character(request, context.limits);
    if (auto* problem = std::get_if<Problem>(&posted)) return std::move(*problem);
    auto& upload = std::get<Upload>(posted);
    if (format != Format::kGlb) upload.file = {};  // has been read, and may be the largest part of all
    auto made = move_character(upload, settings, format, context);
    if (auto* problem = std::get_if<Problem>(&made)) return std::move(*problem);

    const auto& moved = std::get<MovedCharacter>(made);
    const Schedule* schedule = &moved.motion.schedule;
    if (is_motion_file(format)) return tool_file(upload, moved, format, std::get<FileOptions>(options), context);
    if (format == Format::kJson)
        return formatted(format, poses_json(upload, settings, moved, context), "character", schedule);
    auto file = file_with_clip(upload, settings, moved, std::get<FileOptions>(options));
    if (auto* problem = std::get_if<Problem>(&file)) return std::move(*problem);
    return formatted(Format::kGlb, std::get<std::string>(std::move(file)), "character", schedule);
}

}  // namespace tuftwave::server
