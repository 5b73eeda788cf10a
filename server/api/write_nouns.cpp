#include "api/write_nouns.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>

#include "api/choices.hpp"
#include "tuftwave/quality.hpp"

namespace tuftwave::server {
namespace {

using Json = nlohmann::ordered_json;

/// The shortest decimal that reads back to the same float32: half the digits of a double, and enough for a pose.
double short_number(double value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, static_cast<float>(value)).ptr;
    double shortened = 0;
    std::from_chars(digits, end, shortened);
    return shortened;
}

Json to_json(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json pose_json(const Vec3& v) { return Json::array({short_number(v.x), short_number(v.y), short_number(v.z)}); }

Json pose_json(const Quat& q) {
    return Json::array({short_number(q.x), short_number(q.y), short_number(q.z), short_number(q.w)});
}

/// What a decimal can say exactly goes out as a number, whose fraction might have more digits than we read.
Json fps_json(const FrameRate& fps) {
    constexpr std::int64_t kMillion = 1'000'000;
    if (fps.denominator == 1) return fps.numerator;
    if (kMillion % fps.denominator == 0) return fps.value();
    return frame_rate_text(fps);
}

Json to_json(const Head& head) {
    return {{"center", to_json(head.center)},
            {"up", to_json(head.up)},
            {"front", to_json(head.front)},
            {"root_depth", head.root_depth},
            {"diameter_at_100", head.diameter_at_100}};
}

Json to_json(const Tuft& tuft) {
    Json json{{"name", tuft.name}, {"points", Json::array()}};
    for (const Vec3& point : tuft.points) json["points"].push_back(to_json(point));
    json["diameter"] = tuft.diameter;
    json["widest_at"] = tuft.widest_at;
    json["taper"] = word_of(kTapers, tuft.taper);
    json["section"] = word_of(kSections, tuft.section);
    json["flatness"] = tuft.flatness;
    json["twist_deg"] = tuft.twist_deg;
    json["roll_deg"] = tuft.roll_deg;
    json["joints"] = tuft.joints;
    json["phase"] = tuft.phase;
    if (tuft.cycles) json["cycles"] = *tuft.cycles;
    return json;
}

Json to_json(const Timing& timing) {
    return {{"period", timing.period},
            {"fps", fps_json(timing.fps)},
            {"hold", timing.hold},
            {"short_holds", word_of(kShortHolds, timing.short_holds)},
            {"sampling", word_of(kSamplings, timing.sampling)}};
}

Json to_json(const Phasing& phase) {
    Json json{{"step", word_of(kPhaseSteps, phase.step)},
              {"spread", phase.spread},
              {"seed", phase.seed},
              {"cycles", phase.cycles}};
    if (phase.gust_wavelength) json["gust_wavelength"] = *phase.gust_wavelength;
    return json;
}

Json to_json(const Motion& motion) {
    const Wave& wave = motion.wave;
    Json json{{"wave",
               {{"amplitude", wave.amplitude},
                {"spatial_period", wave.spatial_period},
                {"lightness", wave.lightness},
                {"tip_exponent", wave.tip_exponent}}},
              {"timing", to_json(motion.timing)},
              {"mode", word_of(kModes, motion.mode)},
              {"wind", to_json(motion.wind)},
              {"up", to_json(motion.up)},
              {"one_sided", motion.one_sided},
              {"phase", to_json(motion.phase)}};
    if (motion.droop) json["droop"] = word_of(kDroops, *motion.droop);
    if (motion.lift) json["lift"] = *motion.lift;
    return json;
}

}  // namespace

std::string frame_rate_text(const FrameRate& fps) {
    const std::string numerator = std::to_string(fps.numerator);
    return fps.denominator == 1 ? numerator : numerator + "/" + std::to_string(fps.denominator);
}

Json hairstyle_json(const Hairstyle& hairstyle, const gltf::Look& look) {
    Json json{{"head", to_json(hairstyle.head)}, {"tufts", Json::array()}};
    for (const Tuft& tuft : hairstyle.tufts) json["tufts"].push_back(to_json(tuft));
    if (hairstyle.motion) json["motion"] = to_json(*hairstyle.motion);
    json["mesh"] = {{"tolerance", hairstyle.mesh.tolerance},
                    {"sides", hairstyle.mesh.sides},
                    {"layout", word_of(kLayouts, look.layout)},
                    {"color", look.color}};
    if (hairstyle.mesh.rings) json["mesh"]["rings"] = *hairstyle.mesh.rings;
    if (hairstyle.formulas != Formulas::kCorrected) json["formulas"] = word_of(kFormulas, hairstyle.formulas);
    return json;
}

Json schedule_json(const Schedule& schedule) {
    return {{"frames", schedule.frames},     {"pictures", schedule.pictures},
            {"holds", schedule.holds},       {"starts", schedule.starts},
            {"fps", fps_json(schedule.fps)}, {"requested_period", schedule.requested_period},
            {"period", schedule.period}};
}

Json pictures_json(std::span<const Chain> chains, const HairMotion& motion, const std::stop_token& stop) {
    Json pictures = Json::array();
    for (std::size_t n = 0; n < static_cast<std::size_t>(motion.schedule.pictures) && !stop.stop_requested(); ++n) {
        Json poses = Json::array();
        for (std::size_t c = 0; c < chains.size(); ++c) {
            const std::size_t nodes = chains[c].nodes.size();
            const std::span<const Quat> rotations = std::span(motion.chains[c].rotations).subspan(n * nodes, nodes);
            Json turns = Json::array(), places = Json::array();
            for (const Quat& rotation : rotations) turns.push_back(pose_json(rotation));
            for (const Vec3& position : node_positions(chains[c], rotations)) places.push_back(pose_json(position));
            poses.push_back(
                {{"name", chains[c].name}, {"rotations", std::move(turns)}, {"positions", std::move(places)}});
        }
        pictures.push_back({{"chains", std::move(poses)}});
    }
    return pictures;
}

Json quality_json(std::span<const Chain> chains, const Wave& wave, const HairMotion& motion,
                  const std::stop_token& stop) {
    constexpr int kFineBones = 16;
    std::map<int, int> hold_counts;
    for (const int hold : motion.schedule.holds) ++hold_counts[hold];
    double largest = 0;
    for (std::size_t c = 0; c < chains.size() && !stop.stop_requested(); ++c)
        largest = std::max(largest, largest_step(chains[c], motion.chains[c]));
    Json counts = Json::object();
    for (const auto& [hold, count] : hold_counts) counts[std::to_string(hold)] = count;
    return {{"hold_counts", counts},
            {"largest_step_deg", short_number(largest / kRadiansPerDegree)},
            {"tip_crossings", tip_crossings(wave, kFineBones)}};
}

Json warnings_json(const Schedule* schedule) {
    Json warnings = Json::array();
    if (schedule != nullptr && !is_usual_picture_count(schedule->pictures)) {
        warnings.push_back({{"code", "unusual_picture_count"},
                            {"detail", "Animators use 3 to 8 pictures per cycle; these settings give " +
                                           std::to_string(schedule->pictures) + "."}});
    }
    return warnings;
}

}  // namespace tuftwave::server
