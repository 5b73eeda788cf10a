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

Json to_json(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json to_json(const Origin& origin) {
    Json json{{"kind", word_of(kFillKinds, origin.kind)}, {"index", origin.index}};
    if (origin.parent) json["parent"] = *origin.parent;
    return json;
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
    if (tuft.origin) json["origin"] = to_json(*tuft.origin);
    return json;
}

}  // namespace

double short_number(double value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, static_cast<float>(value)).ptr;
    double shortened = 0;
    std::from_chars(digits, end, shortened);
    return shortened;
}

Json pose_json(const Vec3& v) { return Json::array({short_number(v.x), short_number(v.y), short_number(v.z)}); }

Json pose_json(const Quat& q) {
    return Json::array({short_number(q.x), short_number(q.y), short_number(q.z), short_number(q.w)});
}

std::string frame_rate_text(const FrameRate& fps) {
    const std::string numerator = std::to_string(fps.numerator);
    return fps.denominator == 1 ? numerator : numerator + "/" + std::to_string(fps.denominator);
}

Json frame_rate_json(const FrameRate& fps) {
    constexpr std::int64_t kMillion = 1'000'000;
    if (fps.denominator == 1) return fps.numerator;
    if (kMillion % fps.denominator == 0) return fps.value();
    return frame_rate_text(fps);
}

Json wave_json(const Wave& wave) {
    return {{"amplitude", wave.amplitude},
            {"spatial_period", wave.spatial_period},
            {"lightness", wave.lightness},
            {"tip_exponent", wave.tip_exponent}};
}

Json tuft_json(const Tuft& tuft) { return to_json(tuft); }

Json fill_report_json(const FillReport& report) {
    const Gap& gap = report.gap;
    Json resampled = Json::array();
    if (report.is_resampled[0]) resampled.push_back("from");
    if (report.is_resampled[1]) resampled.push_back("to");
    return {{"sweep", gap.sweep},
            {"rise", gap.rise},
            {"gamma", gap.gamma},
            {"distance", gap.distance},
            {"tufts_per_meter", gap.tufts_per_meter},
            {"along", gap.along},
            {"tufts", {{"along", report.along}, {"crown", report.crown}, {"neck", report.neck}}},
            {"removed",
             {{"hairline", report.beyond_hairline},
              {"crowded", report.crowded},
              {"off_scalp", report.off_scalp},
              {"inside", report.inside}}},
            {"moved_out", report.moved_out},
            {"resampled", std::move(resampled)}};
}

Json schedule_json(const Schedule& schedule) {
    return {{"frames", schedule.frames},
            {"pictures", schedule.pictures},
            {"holds", schedule.holds},
            {"starts", schedule.starts},
            {"fps", frame_rate_json(schedule.fps)},
            {"requested_period", schedule.requested_period},
            {"period", schedule.period}};
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

Json warnings_json(const Schedule* schedule, std::span<const FillReport> fills) {
    Json warnings = Json::array();
    if (schedule != nullptr && !is_usual_picture_count(schedule->pictures)) {
        warnings.push_back({{"code", "unusual_picture_count"},
                            {"detail", "Animators use 3 to 8 pictures per cycle; these settings give " +
                                           std::to_string(schedule->pictures) + "."}});
    }
    for (std::size_t i = 0; i < fills.size(); ++i) {
        const FillReport& fill = fills[i];
        if (fill.tuft_count() > 0) continue;
        const bool is_removed = fill.beyond_hairline + fill.crowded + fill.off_scalp + fill.inside > 0;
        const std::string why = is_removed ? "all of them were left out, see removed."
                                           : "its gap is " + to_text(short_number(fill.gap.distance)) +
                                                 " m wide; more density or tufts_per_meter would.";
        warnings.push_back(
            {{"code", "empty_fill"}, {"detail", "Fill " + std::to_string(i + 1) + " adds no tuft: " + why}});
    }
    return warnings;
}

}  // namespace tuftwave::server
