#include "api/motion_file.hpp"

#include "gltf/names.hpp"
#include "poses/bvh.hpp"
#include "poses/usda.hpp"
#include "poses/vmd.hpp"
#include "sheets/csv.hpp"
#include "sheets/track_names.hpp"
#include "sheets/xdts.hpp"

namespace tuftwave::server {
namespace {

Check check_sheet(const MovedChains& moved, std::size_t tracks, int repeat, const Limits& limits) {
    const std::size_t pictures =
        static_cast<std::size_t>(moved.motion.schedule.pictures) * static_cast<std::size_t>(repeat);
    return check_total(tracks * pictures, limits.sheet_cells, "tracks times pictures in the sheet",
                       repeat > 1 ? "?repeat" : moved.pointer);
}

Answer sheet(const MovedChains& moved, Format format, int repeat, const Limits& limits) {
    const Schedule& schedule = moved.motion.schedule;
    if (format == Format::kCsv) return formatted(format, sheets::csv(schedule, repeat), moved.file, &schedule);
    const std::vector<std::string> tracks = sheets::track_names(moved.blocks);
    if (const Check wrong = check_sheet(moved, tracks.size(), repeat, limits)) return to_problem(*wrong);
    return formatted(format, sheets::xdts(schedule, repeat, tracks), moved.file, &schedule);
}

/// How many keys a file of poses has of each joint.
std::size_t keys_of(Format format, const Schedule& schedule, int repeat) {
    switch (format) {
        case Format::kVmd:
            return poses::vmd_keys(schedule, repeat).size();
        case Format::kBvh:
            return static_cast<std::size_t>(schedule.frames);
        default:
            return 2 * static_cast<std::size_t>(schedule.pictures) + 1;
    }
}

std::size_t joints_of(std::span<const Chain> chains) {
    std::size_t joints = 0;
    for (const Chain& chain : chains) joints += chain.nodes.size() - 1;
    return joints;
}

Check check_keys(const MovedChains& moved, Format format, int repeat, const Limits& limits) {
    return check_total(joints_of(moved.chains) * keys_of(format, moved.motion.schedule, repeat), limits.joint_keys,
                       "joints times keys in the file", repeat > 1 ? "?repeat" : moved.pointer);
}

/// The bones' own names, or those that the joints have in a GLB of the same chains.
poses::BoneNames bone_names(const MovedChains& moved) {
    if (!moved.names.empty()) return moved.names;
    const std::vector<std::string> names = gltf::claim_names(moved.chains, moved.kind);
    poses::BoneNames bones;
    for (std::size_t c = 0; c < names.size(); ++c) {
        bones.emplace_back();
        for (std::size_t number = 1; number < moved.chains[c].nodes.size(); ++number)
            bones.back().push_back(gltf::Names::joint(names[c], number));
    }
    return bones;
}

Result<std::string> poses_for(const MovedChains& moved, Format format, int repeat) {
    const poses::BoneNames names = bone_names(moved);
    const poses::PosedHair hair{moved.chains, moved.motion, names};
    if (format == Format::kBvh) return poses::bvh(hair);
    if (format == Format::kUsda) return poses::usda(hair);
    return poses::vmd(hair, repeat);
}

}  // namespace

bool is_motion_file(Format format) {
    return format != Format::kGlb && format != Format::kGltf && format != Format::kJson;
}

Check prescribe_rate(Format format, Timing& timing, Formulas formulas, const Limits& limits) {
    if (format != Format::kVmd) return {};
    const Result<Schedule> asked = make_schedule(timing, formulas, limits);
    timing.fps = poses::kVmdRate;
    if (!asked && asked.error().field == "/fps") return asked.error();
    return {};
}

Error at_prescribed_rate(Format format, Error error) {
    if (format == Format::kVmd && error.field.starts_with("/motion/timing"))
        error.allowed += "; a VMD has 30 frames per second";
    return error;
}

Check check_clip(std::span<const Chain> chains, const Schedule& schedule, gltf::Holding holding,
                 const std::string& pointer, const Limits& limits) {
    if (holding == gltf::Holding::kStep) return {};
    return check_total(joints_of(chains) * gltf::clip_keys(schedule, holding).times.size(), limits.joint_keys,
                       "joints times keys in the file", pointer);
}

Answer motion_file(const MovedChains& moved, Format format, const FileOptions& options, const Limits& limits) {
    if (Check wrong = check_repeat(moved.motion.schedule, options.repeat, limits)) {
        wrong->field = "?repeat";
        return to_problem(*wrong);
    }
    if (format == Format::kXdts || format == Format::kCsv) return sheet(moved, format, options.repeat, limits);
    if (const Check wrong = check_keys(moved, format, options.repeat, limits)) return to_problem(*wrong);
    Result<std::string> text = poses_for(moved, format, options.repeat);
    if (!text) return to_problem(text.error(), moved.pointer);
    return formatted(format, std::move(text).value(), moved.file, &moved.motion.schedule);
}

}  // namespace tuftwave::server
