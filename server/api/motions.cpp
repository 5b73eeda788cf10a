#include "api/motions.hpp"

#include <nlohmann/json.hpp>

#include "api/body.hpp"
#include "api/formats.hpp"
#include "api/motion_file.hpp"
#include "api/pose_text.hpp"
#include "api/read_nouns.hpp"
#include "api/write_nouns.hpp"
#include "gltf/hair_file.hpp"
#include "gltf/json_text.hpp"
#include "tuftwave/motion.hpp"
#include "tuftwave/vector_checks.hpp"
#include "version.hpp"

namespace tuftwave::server {
namespace {

using Json = nlohmann::ordered_json;

struct MotionRequest {
    std::optional<Head> head;
    std::vector<Chain> chains;
    Motion motion;
    Formulas formulas = Formulas::kCorrected;
};

std::variant<MotionRequest, Problem> read_request(const JsonValue body, const Limits& limits) {
    MotionRequest read;
    FieldProblems problems;
    const Place root;
    Fields fields(body, root, problems);
    fields.require("chains");
    fields.member("head", [&](const JsonValue head, const Place& place) {
        read_head(head, place, problems, limits, read.head.emplace());
    });
    if (read.head) read.motion.up = read.head->up;
    fields.elements("chains", limits.chains, read.chains, [&](const JsonValue value, const Place& place, Chain& chain) {
        read_chain(value, place, problems, limits, chain);
    });
    fields.member("motion", [&](const JsonValue motion, const Place& place) {
        read_motion(motion, place, problems, limits, read.motion);
    });
    read_formulas(fields, read.formulas);
    fields.done();
    if (!problems.empty()) return fields_problem(problems.take());
    return read;
}

/// What a request says; its JSON is gone when the work begins.
std::variant<MotionRequest, Problem> read_request(const Request& request, const Limits& limits) {
    auto body = read_body(request);
    if (auto* problem = std::get_if<Problem>(&body)) return std::move(*problem);
    return read_request(std::get<JsonDocument>(body).root(), limits);
}

/// Chains that do not say where outward is take it from the head.
void set_outward(MotionRequest& request) {
    if (!request.head) return;
    for (Chain& chain : request.chains) {
        const Vec3 away = chain.nodes.front() - request.head->center;
        if (!chain.outward && length(away) > kShortestDirection) chain.outward = normalized(away);
    }
}

Result<HairMotion> move(MotionRequest& request, Format format, const Context& context) {
    if (request.head) {
        if (Check wrong = check_head(*request.head, context.limits)) return within("/head", *wrong);
    }
    if (Check wrong = check_chains(request.chains, context.limits)) return within("/chains", *wrong);
    set_outward(request);
    if (Check wrong = prescribe_rate(format, request.motion.timing, request.formulas, context.limits))
        return within("/motion/timing", *wrong);
    Result<Schedule> schedule = make_schedule(request.motion.timing, request.formulas, context.limits);
    if (!schedule) return at_prescribed_rate(format, within("/motion/timing", schedule.error()));
    auto moved = move_chains(request.chains, request.motion, *schedule, context.limits, context.for_each, context.stop);
    if (!moved) return moved.error();
    return HairMotion{std::move(schedule).value(), std::move(moved).value()};
}

std::string answer_json(const MotionRequest& request, const HairMotion& motion, const std::stop_token& stop) {
    const Json answer{{"schedule", schedule_json(motion.schedule)},
                      {"pictures", nullptr},
                      {"quality", quality_json(request.chains, request.motion.wave, motion, stop)},
                      {"warnings", warnings_json(&motion.schedule)}};
    const std::vector<ChainPoses> poses = chain_poses(request.chains, motion, stop);
    if (stop.stop_requested()) return "";
    return text_with_poses(answer.dump(), poses, static_cast<std::size_t>(motion.schedule.pictures));
}

gltf::File clip_bytes(const MotionRequest& request, const HairMotion& motion, Format format, gltf::Holding holding) {
    const nlohmann::json schedule = schedule_json(motion.schedule);
    const nlohmann::json extras{
        {"tuftwave", {{"version", kVersion}, {"schedule", schedule}, {"warnings", warnings_json(&motion.schedule)}}}};
    return gltf::clip_file(request.chains, motion, gltf::extras_text(extras), {schedule, holding},
                           format == Format::kGlb ? gltf::Container::kGlb : gltf::Container::kGltf);
}

Answer answer(const MotionRequest& request, const HairMotion& motion, Format format, const FileOptions& options,
              const Context& context) {
    if (is_motion_file(format)) {
        MovedChains moved{request.chains, motion, "chain", "/chains", "motion", {}};
        for (const Chain& chain : request.chains) moved.blocks.push_back(chain.block);
        return motion_file(moved, format, options, context.limits);
    }
    if (format == Format::kJson)
        return formatted(format, answer_json(request, motion, context.stop), "motion", &motion.schedule);
    if (Check wrong = check_clip(request.chains, motion.schedule, options.holding, "/chains", context.limits))
        return to_problem(*wrong);
    return formatted(format, clip_bytes(request, motion, format, options.holding), "motion", &motion.schedule);
}

}  // namespace

Answer post_motions(const Request& request, const Context& context) {
    if (auto problem = check_query(request, {"format", "repeat", "interpolation"})) return *std::move(problem);
    auto chosen = choose_format(request, {Format::kJson, Format::kGlb, Format::kGltf, Format::kXdts, Format::kCsv,
                                          Format::kVmd, Format::kBvh, Format::kUsda});
    if (auto* problem = std::get_if<Problem>(&chosen)) return std::move(*problem);
    const Format format = std::get<Format>(chosen);
    auto read_options = read_file_options(request, format, context.limits);
    if (auto* problem = std::get_if<Problem>(&read_options)) return std::move(*problem);
    const FileOptions& options = std::get<FileOptions>(read_options);
    auto read = read_request(request, context.limits);
    if (auto* problem = std::get_if<Problem>(&read)) return std::move(*problem);

    auto& wanted = std::get<MotionRequest>(read);
    const Result<HairMotion> motion = move(wanted, format, context);
    if (!motion) return to_problem(motion.error());
    return answer(wanted, *motion, format, options, context);
}

}  // namespace tuftwave::server
