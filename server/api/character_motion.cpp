#include "api/character_motion.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "api/body.hpp"
#include "api/choices.hpp"
#include "api/choose_chains.hpp"
#include "api/file_options.hpp"
#include "api/formats.hpp"
#include "api/motion_file.hpp"
#include "api/query_body.hpp"
#include "api/read_character.hpp"
#include "api/read_nouns.hpp"
#include "api/write_character.hpp"
#include "api/write_nouns.hpp"
#include "character/clip.hpp"
#include "character/springs.hpp"
#include "tuftwave/motion.hpp"

namespace tuftwave::server {
namespace {

using Json = nlohmann::ordered_json;

enum class Springs { kKeep, kRemove };

constexpr Choices<Springs, 2> kSpringChoices{{{"keep", Springs::kKeep}, {"remove", Springs::kRemove}}};
constexpr std::size_t kLongestClipName = 64;  // characters

constexpr std::array<QueryField, 28> kQueryFields{{{"amplitude", "/motion/wave/amplitude"},
                                                   {"spatial_period", "/motion/wave/spatial_period"},
                                                   {"lightness", "/motion/wave/lightness"},
                                                   {"tip_exponent", "/motion/wave/tip_exponent"},
                                                   {"period", "/motion/timing/period"},
                                                   {"fps", "/motion/timing/fps"},
                                                   {"hold", "/motion/timing/hold"},
                                                   {"short_holds", "/motion/timing/short_holds"},
                                                   {"sampling", "/motion/timing/sampling"},
                                                   {"mode", "/motion/mode"},
                                                   {"wind", "/motion/wind"},
                                                   {"up", "/motion/up"},
                                                   {"droop", "/motion/droop"},
                                                   {"one_sided", "/motion/one_sided"},
                                                   {"lift", "/motion/lift"},
                                                   {"phase_step", "/motion/phase/step"},
                                                   {"gust_wavelength", "/motion/phase/gust_wavelength"},
                                                   {"spread", "/motion/phase/spread"},
                                                   {"seed", "/motion/phase/seed"},
                                                   {"cycles", "/motion/phase/cycles"},
                                                   {"phases", "/phases", QueryValue::kNumbers},
                                                   {"formulas", "/formulas"},
                                                   {"repeat", "/repeat"},
                                                   {"interpolation", "/interpolation", QueryValue::kText},
                                                   {"chains", "/chains", QueryValue::kText},
                                                   {"kinds", "/kinds", QueryValue::kText},
                                                   {"springs", "/springs", QueryValue::kText},
                                                   {"clip_name", "/clip_name", QueryValue::kText}}};

struct Settings {
    Motion motion;
    Formulas formulas = Formulas::kCorrected;
    ChainChoice choice;
    std::vector<double> phases;  ///< radians, one per chain that moves; empty is 0 for all
    Springs springs = Springs::kKeep;
    std::string clip_name = "wave";
};

std::variant<Settings, Problem> read_settings(const Request& request, const Limits& limits) {
    for (const auto& [name, value] : request.query) {
        if (value.empty())
            return fields_problem({{ProblemCode::kWrongType, "?" + name.substr(0, 64), "", "a value", {}, {}}});
    }
    const nlohmann::json body = query_body(request, kQueryFields);
    Settings read;
    FieldProblems problems;
    const Place root;
    Fields fields(body, root, problems);
    fields.member("motion", [&](const nlohmann::json& motion, const Place& place) {
        read_motion(motion, place, problems, limits, read.motion);
    });
    read_formulas(fields, read.formulas);
    fields.text("chains", 1024, read.choice.chains);
    fields.text("kinds", 64, read.choice.kinds);
    fields.numbers("phases", limits.chains, limits.phase, read.phases);
    fields.choice("springs", kSpringChoices, read.springs);
    fields.text("clip_name", kLongestClipName, read.clip_name);
    if (problems.empty()) return read;
    return as_query_problem(fields_problem(problems.take()), kQueryFields);
}

/// What is to be moved, and how it moves.
struct Moved {
    std::vector<std::size_t> chosen;
    std::vector<Chain> chains;
    HairMotion motion;
};

std::variant<Moved, Problem> move(const Upload& upload, const Settings& settings, Format format,
                                  const Context& context) {
    const auto in_query = [](const Error& error, const std::string& place) {
        return as_query_problem(to_problem(error, place), kQueryFields);
    };
    if (settings.motion.one_sided && upload.found.head < 0)
        return fields_problem(
            {{ProblemCode::kDegenerate, "?one_sided", {}, "false, since no node is called a head", {}, {}}});
    Timing timing = settings.motion.timing;
    if (const Check wrong = prescribe_rate(format, timing, settings.formulas, context.limits))
        return in_query(*wrong, "/motion/timing");
    auto schedule = make_schedule(timing, settings.formulas, context.limits);
    if (!schedule) return in_query(at_prescribed_rate(format, within("/motion/timing", schedule.error())), "");
    auto chosen = choose_chains(upload.found, settings.choice);
    if (auto* problem = std::get_if<Problem>(&chosen)) return std::move(*problem);
    Moved moved{std::get<std::vector<std::size_t>>(std::move(chosen)), {}, {}};
    if (!settings.phases.empty() && settings.phases.size() != moved.chosen.size())
        return fields_problem({{ProblemCode::kConflict,
                                "?phases",
                                static_cast<double>(settings.phases.size()),
                                "a number for each of the " + std::to_string(moved.chosen.size()) + " chains that move",
                                {},
                                {}}});
    for (std::size_t c = 0; c < moved.chosen.size(); ++c) {
        const character::FoundChain& found = upload.found.chains[moved.chosen[c]];
        moved.chains.push_back(character::to_chain(upload.character, upload.found, found));
        if (!settings.phases.empty()) moved.chains.back().phase = settings.phases[c];
    }
    if (const Check wrong = check_chains(moved.chains, context.limits)) return to_problem(*wrong, "/chains");
    auto motions =
        move_chains(moved.chains, settings.motion, *schedule, context.limits, context.for_each, context.stop);
    if (!motions) return in_query(motions.error(), "");
    moved.motion = {std::move(schedule).value(), std::move(motions).value()};
    return moved;
}

std::vector<character::FoundChain> moved_chains(const Upload& upload, const Moved& moved) {
    std::vector<character::FoundChain> chains;
    for (const std::size_t index : moved.chosen) chains.push_back(upload.found.chains[index]);
    return chains;
}

std::vector<character::NodeKeys> node_keys(const Upload& upload, const Moved& moved) {
    std::vector<character::NodeKeys> keys;
    const auto pictures = static_cast<std::size_t>(moved.motion.schedule.pictures);
    for (std::size_t c = 0; c < moved.chosen.size(); ++c) {
        const character::FoundChain& chain = upload.found.chains[moved.chosen[c]];
        for (std::size_t i = 0; i < chain.bones.size(); ++i) {
            character::NodeKeys& node = keys.emplace_back(character::NodeKeys{chain.bones[i], {}});
            for (std::size_t n = 0; n < pictures; ++n) {
                const Quat& rotation = moved.motion.chains[c].rotations[n * moved.chains[c].nodes.size() + i];
                node.rotations.push_back(character::to_node_rotation(upload.character, chain, i, rotation));
            }
        }
    }
    return keys;
}

Json warnings(const Upload& upload, const Settings& settings, const Moved& moved) {
    Json warnings = warnings_json(&moved.motion.schedule);
    const std::size_t count = character::count_springs(upload.character, moved_chains(upload, moved));
    if (settings.springs == Springs::kKeep && count > 0)
        warnings.push_back({{"code", "springs_overwrite"},
                            {"detail", "A VRM player runs its springs after the clip and overwrites it on " +
                                           std::to_string(count) + " of them; springs=remove takes them out."}});
    return warnings;
}

std::string poses_json(const Upload& upload, const Settings& settings, const Moved& moved, const Context& context) {
    Json chains = Json::array();
    for (const std::size_t index : moved.chosen) chains.push_back(found_chain_json(upload, index));
    return Json{{"facing", upload.character.faces_minus_z ? "-Z" : "+Z"},
                {"schedule", schedule_json(moved.motion.schedule)},
                {"chains", std::move(chains)},
                {"pictures", character_pictures_json(upload, moved_chains(upload, moved), moved.chains, moved.motion,
                                                     context.stop)},
                {"quality", quality_json(moved.chains, settings.motion.wave, moved.motion, context.stop)},
                {"warnings", warnings(upload, settings, moved)}}
        .dump();
}

/// What the bones are called in the file: tools that have the same model find them by that.
std::variant<poses::BoneNames, Problem> bone_names(const Upload& upload, const Moved& moved, Format format) {
    poses::BoneNames names;
    std::set<std::string> used;
    for (const std::size_t index : moved.chosen) {
        std::vector<std::string>& bones = names.emplace_back();
        for (const int bone : upload.found.chains[index].bones) {
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
std::vector<std::string> blocks(const Upload& upload, const Moved& moved) {
    std::vector<std::string> kinds;
    for (const std::size_t index : moved.chosen) kinds.emplace_back(word_of(kKinds, upload.found.chains[index].kind));
    return kinds;
}

Answer tool_file(const Upload& upload, const Moved& moved, Format format, const FileOptions& options,
                 const Context& context) {
    auto names = bone_names(upload, moved, format);
    if (auto* problem = std::get_if<Problem>(&names)) return std::move(*problem);
    const std::vector<Chain> chains = facing_as(format, upload, moved.chains);
    Answer answer = motion_file({chains, moved.motion, "chain", "/chains", "character", blocks(upload, moved),
                                 std::get<poses::BoneNames>(names)},
                                format, options, context.limits);
    if (auto* problem = std::get_if<Problem>(&answer)) return as_query_problem(std::move(*problem), kQueryFields);
    return answer;
}

std::variant<std::string, Problem> file_with_clip(Upload& upload, const Settings& settings, const Moved& moved,
                                                  const FileOptions& options) {
    const std::size_t binary_bytes = upload.glb.binary.size();
    if (const auto fault = character::check_clip_fits(upload.file, settings.clip_name, binary_bytes))
        return to_problem(*fault);
    if (settings.springs == Springs::kRemove)
        character::remove_springs(upload.file, upload.character, moved_chains(upload, moved));
    const std::string added =
        character::add_held_clip(upload.file, upload.character, node_keys(upload, moved),
                                 gltf::clip_keys(moved.motion.schedule, options.holding), settings.clip_name,
                                 schedule_json(moved.motion.schedule), binary_bytes);
    return character::join_glb(upload.file.dump(), upload.glb.binary, added, upload.glb.others);
}

}  // namespace

Answer post_character_motion(const Request& request, const Context& context) {
    if (auto problem = check_query(request, names_of(kQueryFields))) return *std::move(problem);
    auto chosen = choose_format(
        request, {Format::kGlb, Format::kJson, Format::kXdts, Format::kCsv, Format::kVmd, Format::kBvh, Format::kUsda});
    if (auto* problem = std::get_if<Problem>(&chosen)) return std::move(*problem);
    const Format format = std::get<Format>(chosen);
    auto options = read_file_options(request, format, context.limits);
    if (auto* problem = std::get_if<Problem>(&options)) return std::move(*problem);
    auto read = read_settings(request, context.limits);
    if (auto* problem = std::get_if<Problem>(&read)) return std::move(*problem);
    const auto& settings = std::get<Settings>(read);
    auto posted = read_character(request, context.limits);
    if (auto* problem = std::get_if<Problem>(&posted)) return std::move(*problem);
    auto& upload = std::get<Upload>(posted);
    auto made = move(upload, settings, format, context);
    if (auto* problem = std::get_if<Problem>(&made)) return std::move(*problem);

    const auto& moved = std::get<Moved>(made);
    const Schedule* schedule = &moved.motion.schedule;
    if (is_motion_file(format)) return tool_file(upload, moved, format, std::get<FileOptions>(options), context);
    if (format == Format::kJson)
        return formatted(format, poses_json(upload, settings, moved, context), "character", schedule);
    auto file = file_with_clip(upload, settings, moved, std::get<FileOptions>(options));
    if (auto* problem = std::get_if<Problem>(&file)) return std::move(*problem);
    return formatted(Format::kGlb, std::get<std::string>(std::move(file)), "character", schedule);
}

}  // namespace tuftwave::server
