#include "api/hair.hpp"

#include <nlohmann/json.hpp>

#include "api/body.hpp"
#include "api/choices.hpp"
#include "api/formats.hpp"
#include "api/hair_bytes.hpp"
#include "api/motion_file.hpp"
#include "api/pose_text.hpp"
#include "api/read_nouns.hpp"
#include "api/write_nouns.hpp"
#include "sheets/track_names.hpp"
#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server {
namespace {

using Json = nlohmann::ordered_json;

/// Whether a request may move the hair.
enum class Stillness { kStill, kMoving };

/// Finds the tuft that a fill names. @return  its index, where exactly one tuft is called that
std::optional<std::size_t> find_tuft(const std::vector<Tuft>& tufts, const std::string& name,
                                     const std::string& pointer, FieldProblems& problems) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < tufts.size(); ++i) {
        if (tufts[i].name != name) continue;
        if (found) {
            problems.add({ProblemCode::kConflict, pointer, name, "a name that only one tuft has", {}, {}});
            return {};
        }
        found = i;
    }
    if (!found) problems.add({ProblemCode::kNotAChoice, pointer, name, "the name of a tuft", {}, {}});
    return found;
}

void read_fill(const JsonValue value, const Place& place, FieldProblems& problems, Hairstyle& hairstyle) {
    HairFill& fill = hairstyle.fills.emplace_back();
    fill.settings.name = "fill" + std::to_string(hairstyle.fills.size());
    Fields fields(value, place, problems);
    fields.require("from");
    std::optional<std::string> from, to;
    if (value.find("from")) fields.text("from", kLongestName, from.emplace());
    fields.text("to", kLongestName, to);
    read_fill_settings(fields, problems, fill.settings);
    std::optional<Formulas> formulas;
    fields.choice("formulas", kFormulas, formulas);
    fill.settings.formulas = formulas.value_or(hairstyle.formulas);
    fields.done();
    if (!problems.empty()) return;  // a name that was not read would be missed, too
    if (from) fill.from = find_tuft(hairstyle.tufts, *from, place.pointer() + "/from", problems).value_or(0);
    if (to) fill.to = find_tuft(hairstyle.tufts, *to, place.pointer() + "/to", problems);
}

std::variant<HairRequest, Problem> read_hair(const JsonValue body, Stillness stillness, const Limits& limits) {
    HairRequest read;
    FieldProblems problems;
    const Place root;
    Fields fields(body, root, problems);
    Hairstyle& hairstyle = read.hairstyle;
    fields.require("tufts");
    fields.member("head", [&](const JsonValue head, const Place& place) {
        read_head(head, place, problems, limits, hairstyle.head);
    });
    fields.elements("tufts", limits.tufts, hairstyle.tufts, [&](const JsonValue value, const Place& place, Tuft& tuft) {
        read_tuft(value, place, problems, limits, tuft);
    });
    fields.member("mesh", [&](const JsonValue mesh, const Place& place) {
        read_mesh(mesh, place, problems, limits, hairstyle.mesh, read.look);
    });
    if (stillness == Stillness::kMoving) {
        fields.optional_member("motion", [&](const JsonValue motion, const Place& place) {
            hairstyle.motion.emplace().up = hairstyle.head.up;
            read_motion(motion, place, problems, limits, *hairstyle.motion);
        });
        read_formulas(fields, hairstyle.formulas);
        fields.items("fills", limits.fills,
                     [&](const JsonValue fill, const Place& place) { read_fill(fill, place, problems, hairstyle); });
    }
    fields.done();
    if (!problems.empty()) return fields_problem(problems.take());
    return read;
}

/// What a request says; its JSON, which may be the largest part of all, is gone when the work begins.
std::variant<HairRequest, Problem> read_hair(const Request& request, Stillness stillness, const Limits& limits) {
    auto body = read_body(request);
    if (auto* problem = std::get_if<Problem>(&body)) return std::move(*problem);
    return read_hair(std::get<JsonDocument>(body).root(), stillness, limits);
}

std::string report_text(const HairRequest& hair, const HairPlan& plan, const std::stop_token& stop) {
    Json report{{"tufts", Json::array()}};
    for (std::size_t i = 0; i < plan.tufts.size(); ++i) {
        const MeshPlan& tuft = plan.tufts[i];
        report["tufts"].push_back({{"name", plan.chains[i].name},
                                   {"vertices", tuft.vertex_count()},
                                   {"triangles", tuft.index_count() / 3},
                                   {"joints", tuft.joints}});
    }
    report["totals"] = {{"tufts", plan.tufts.size()},
                        {"vertices", plan.vertices},
                        {"triangles", plan.indices / 3},
                        {"joints", plan.joints}};
    const Schedule* schedule = nullptr;
    if (plan.motion) {
        schedule = &plan.motion->schedule;
        report["schedule"] = schedule_json(*schedule);
        report["pictures"] = nullptr;
        report["quality"] = quality_json(plan.chains, hair.hairstyle.motion->wave, *plan.motion, stop);
    }
    report["fills"] = Json::array();
    for (const FillReport& fill : plan.fills) report["fills"].push_back(fill_report_json(fill));
    report["warnings"] = warnings_json(schedule, plan.fills);
    if (schedule == nullptr) return report.dump();
    const std::string text = report.dump();
    report = nullptr;
    const std::vector<ChainPoses> poses = chain_poses(plan.chains, *plan.motion, stop);
    if (stop.stop_requested()) return "";
    return text_with_poses(text, poses, static_cast<std::size_t>(schedule->pictures));
}

/// The drawn tufts are one block, and those of each fill another.
std::vector<std::string> blocks_of(const Hairstyle& hairstyle, const HairPlan& plan) {
    std::vector<std::string> blocks{sheets::kHairTrack};
    for (std::size_t i = 0; i < plan.fills.size(); ++i) {
        if (plan.fills[i].tuft_count() > 0) blocks.push_back(hairstyle.fills[i].settings.name);
    }
    return blocks;
}

/// Why there must be a motion, if there must.
std::string use_of_motion(Format format, const FileOptions& options) {
    if (format == Format::kXdts || format == Format::kCsv) return "a sheet was";
    if (is_motion_file(format)) return "poses were";
    const bool is_plain = options.holding == gltf::Holding::kStep && options.kind == gltf::ClipKind::kSkeleton;
    return is_plain ? "" : "a clip was";
}

/// What a format needs beyond a hairstyle. @param hair  takes the frame rate that the format prescribes
std::optional<Problem> prepare_for(Format format, const FileOptions& options, HairRequest& hair, const Limits& limits) {
    std::optional<Motion>& motion = hair.hairstyle.motion;
    const std::string use = use_of_motion(format, options);
    if (!motion && !use.empty())
        return fields_problem(
            {{ProblemCode::kMissingField, "/motion", {}, "a motion, since " + use + " asked for", {}, {}}});
    if (!motion) return {};
    if (const Check wrong = prescribe_rate(format, motion->timing, hair.hairstyle.formulas, limits))
        return to_problem(*wrong, "/motion/timing");
    return {};
}

Check check_flip_book(const HairPlan& plan, const Limits& limits) {
    return check_total(plan.vertices * static_cast<std::size_t>(plan.motion->schedule.pictures), limits.vertices,
                       "vertices in all pictures; use a larger tolerance, fewer rings, fewer sides or fewer pictures",
                       "/mesh");
}

/// The answer once everything but vertices and words has been made.
Answer answer_plan(const HairRequest& hair, const HairPlan& plan, Format format, const FileOptions& options,
                   const Context& context) {
    if (is_motion_file(format))
        return motion_file({plan.chains, *plan.motion, "tuft", "/tufts", "hair", blocks_of(hair.hairstyle, plan)},
                           format, options, context.limits);
    const Schedule* schedule = plan.motion ? &plan.motion->schedule : nullptr;
    if (format == Format::kJson) return formatted(format, report_text(hair, plan, context.stop), "hair", schedule);
    if (schedule != nullptr) {
        const Check wrong = options.kind == gltf::ClipKind::kFlipBook
                                ? check_flip_book(plan, context.limits)
                                : check_clip(plan.chains, *schedule, options.holding, "/tufts", context.limits);
        if (wrong) return to_problem(*wrong);
    }
    return formatted(format, hair_bytes(hair, plan, format, context, options), "hair", schedule);
}

Answer answer_hair(const Request& request, const Context& context, Stillness stillness, Format format,
                   const FileOptions& options) {
    auto read = read_hair(request, stillness, context.limits);
    if (auto* problem = std::get_if<Problem>(&read)) return std::move(*problem);
    auto& hair = std::get<HairRequest>(read);
    if (auto problem = prepare_for(format, options, hair, context.limits)) return *std::move(problem);
    const Result<HairPlan> plan = plan_hairstyle(hair.hairstyle, context.limits, context.for_each, context.stop);
    if (!plan) return to_problem(at_prescribed_rate(format, plan.error()));
    return answer_plan(hair, *plan, format, options, context);
}

}  // namespace

Answer post_tufts(const Request& request, const Context& context) {
    if (auto problem = check_query(request, {"format", "compression"})) return *std::move(problem);
    auto chosen = choose_format(request, {Format::kGlb, Format::kGltf});
    if (auto* problem = std::get_if<Problem>(&chosen)) return std::move(*problem);
    const Format format = std::get<Format>(chosen);
    auto options = read_file_options(request, format, context.limits);
    if (auto* problem = std::get_if<Problem>(&options)) return std::move(*problem);
    return answer_hair(request, context, Stillness::kStill, format, std::get<FileOptions>(options));
}

Answer post_hairstyles(const Request& request, const Context& context) {
    if (auto problem = check_query(request, {"format", "repeat", "interpolation", "clip", "compression"}))
        return *std::move(problem);
    auto chosen = choose_format(request, {Format::kGlb, Format::kGltf, Format::kJson, Format::kXdts, Format::kCsv,
                                          Format::kVmd, Format::kBvh, Format::kUsda});
    if (auto* problem = std::get_if<Problem>(&chosen)) return std::move(*problem);
    const Format format = std::get<Format>(chosen);
    auto options = read_file_options(request, format, context.limits);
    if (auto* problem = std::get_if<Problem>(&options)) return std::move(*problem);
    return answer_hair(request, context, Stillness::kMoving, format, std::get<FileOptions>(options));
}

}  // namespace tuftwave::server
