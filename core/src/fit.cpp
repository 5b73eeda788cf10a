// Based on: K. Furukawa, S. Nakata. Automatic Generation of the Periodic Hair Motion of 3D Characters for Anime
// Production. ICEC 2018. Equation (1), read backwards: from drawn lines to the wave.
// Differs: the paper chooses its waves by eye. Distances of nodes are made least, not angles: on noisy lines that
// recovers the wave two to three times better.
#include "tuftwave/fit.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "drawn_plane.hpp"
#include "fit_refine.hpp"
#include "fit_start.hpp"
#include "tuftwave/elementary.hpp"
#include "tuftwave/vector_checks.hpp"
#include "wave_unknowns.hpp"

namespace tuftwave {
namespace {

constexpr int kTrialSteps = 8;   // enough to tell which starts lead somewhere
constexpr int kFinalSteps = 40;  // enough to tell which of the nearest is the best
constexpr std::size_t kFinalists = 4;
constexpr double kGuesses[] = {1.2, 0.4, 4};  // of the lightness, where only a refinement can tell it
constexpr double kSure = 3;                   // standard deviations by which a droop must differ from none
constexpr double kStillShare = 1e-9;          // of the rest length: pictures nearer than this are one picture

bool is_nearer(const Refinement& a, const Refinement& b) { return a.cost() < b.cost(); }

/// One drawing's search for its wave.
class Search {
  public:
    Search(const DrawnPlane& plane, const FitSettings& settings, const Limits& limits, std::stop_token stop)
        : plane_(plane), settings_(settings), limits_(limits), bounds_(plane, limits), stop_(std::move(stop)) {}

    void run() {
        const Refinement best = free_wave();
        const double swing = swing_of(best.unknowns()), droop = best.unknowns()[kDroop];
        const double uncertain = kSure * best.droop_deviation();
        const double lightness = droop == 0 ? limits_.lightness.maximum : swing / droop;
        const Range range = lightness_range(swing, limits_);
        is_droop_known_ = std::abs(droop) > uncertain && is_within(std::abs(lightness), range);
        lightness_ = lightness;
        unknowns_ = best.unknowns();
        if (is_droop_known_) return;
        // A relative motion hardly shows its droop; of the waves that fit, the most usual one is taken.
        if (plane_.is_centered)
            lightness_ = swing / std::clamp(swing / Wave{}.lightness, droop - uncertain, droop + uncertain);
        const double size = std::isfinite(lightness_) ? std::abs(lightness_) : range.maximum;
        lightness_ = (lightness_ < 0 ? -1 : 1) * std::clamp(size, range.minimum, range.maximum);
        Refinement tied(plane_, bounds_, unknowns_, lightness_);
        follow(tied, settings_.steps);
        is_complete_ = is_complete_ && tied.is_settled();
        unknowns_ = tied.unknowns();
    }

    Wave wave() const { return wave_of(unknowns_, lightness_, limits_); }
    double phase() const { return elementary::atan2(unknowns_[kSine], unknowns_[kCosine]); }
    int steps() const { return steps_; }
    bool is_complete() const { return is_complete_; }
    bool is_droop_known() const { return is_droop_known_; }

  private:
    /// Takes at most `most` steps, and none beyond the budget.
    void follow(Refinement& refinement, int most) {
        for (int i = 0; i < most && !refinement.is_settled(); ++i) {
            if (steps_ >= settings_.steps || stop_.stop_requested()) return;
            refinement.step();
            ++steps_;
        }
    }

    /// The likeliest waves, a few steps on, the nearest first. A relative motion hardly shows its droop: there each is
    /// tried with several lightnesses.
    std::vector<Refinement> trials() {
        std::vector<std::optional<double>> guesses{std::nullopt};
        if (plane_.is_centered) guesses.assign(std::begin(kGuesses), std::end(kGuesses));
        std::vector<Refinement> trials;
        for (const WaveUnknowns& start : likely_waves(plane_, bounds_)) {
            for (const std::optional<double> lightness : guesses) {
                trials.emplace_back(plane_, bounds_, start, lightness);
                follow(trials.back(), kTrialSteps);
            }
        }
        std::stable_sort(trials.begin(), trials.end(), is_nearer);
        return trials;
    }

    /// The best wave whose droop is free.
    Refinement free_wave() {
        std::vector<Refinement> finalists;
        for (const Refinement& trial : trials()) {
            finalists.emplace_back(plane_, bounds_, trial.unknowns(), std::nullopt);
            follow(finalists.back(), kFinalSteps);
            if (finalists.size() == kFinalists) break;
        }
        Refinement best = *std::min_element(finalists.begin(), finalists.end(), is_nearer);
        follow(best, settings_.steps);
        is_complete_ = best.is_settled();
        return best;
    }

    const DrawnPlane& plane_;
    const FitSettings& settings_;
    const Limits& limits_;
    WaveBounds bounds_;
    std::stop_token stop_;
    WaveUnknowns unknowns_{};
    double lightness_ = 1;
    int steps_ = 0;
    bool is_complete_ = false, is_droop_known_ = false;
};

/// Pictures evenly over a cycle, each held for one frame.
Schedule even_schedule(std::size_t pictures) {
    Schedule schedule;
    schedule.frames = schedule.pictures = static_cast<int>(pictures);
    for (int n = 0; n < schedule.pictures; ++n) {
        schedule.starts.push_back(n);
        schedule.holds.push_back(1);
    }
    return schedule;
}

Motion motion_of(const Wave& wave, const FitSettings& settings) {
    Motion motion;
    motion.wave = wave;
    motion.mode = settings.mode;
    motion.wind = settings.wind;
    motion.up = settings.up;
    return motion;
}

/// The lines that a motion with the fitted wave has, so that what is reported is what a caller gets.
std::vector<Line> moved_lines(const Fit& fit, const FitSettings& settings, const Schedule& schedule,
                              const Limits& limits) {
    Chain chain;
    chain.nodes = fit.rest;
    chain.rest_rotations.resize(fit.rest.size());
    chain.phase = fit.phase;
    const auto moved =
        *move_chains({&chain, 1}, motion_of(fit.wave, settings), schedule, limits, InOrder(), std::stop_token{});
    std::vector<Line> lines;
    const std::span<const Quat> rotations = moved.front().rotations;
    for (std::size_t at = 0; at < rotations.size(); at += fit.rest.size())
        lines.push_back(node_positions(chain, rotations.subspan(at, fit.rest.size())));
    return lines;
}

Fit fit_wave(const Drawing& drawing, const FitSettings& settings, const Schedule& schedule, const Limits& limits,
             const std::stop_token& stop) {
    const DrawnPlane plane(drawing, settings, schedule);
    Fit fit;
    fit.rest = plane.rest;
    fit.still = still_error(drawing.pictures, plane.rest_length);
    const bool is_still = fit.still.mean.position < kStillShare;
    const auto warn_if = [&](bool condition, FitWarning warning) {
        if (condition) fit.warnings.push_back(warning);
    };
    fit.wave.amplitude = 0;
    fit.is_complete = true;
    warn_if(plane.pictures() == 2, FitWarning::kTwoPictures);
    warn_if(is_still, FitWarning::kStill);
    if (stop.stop_requested()) {
        fit.is_complete = false;
    } else if (!is_still || !plane.is_centered) {
        Search search(plane, settings, limits, stop);
        search.run();
        fit.wave = search.wave();
        fit.phase = search.phase();
        fit.steps = search.steps();
        fit.is_complete = search.is_complete();
        warn_if(!search.is_droop_known(), FitWarning::kDroopNotIdentifiable);
    }
    fit.error = *measure_error(moved_lines(fit, settings, schedule, limits), drawing.pictures, plane.rest_length);
    warn_if(!is_still && fit.error.mean.position >= fit.still.mean.position, FitWarning::kNoBetterThanStill);
    return fit;
}

Error no_length(const std::string& field) {
    return {ErrorCode::kDegenerate, field, {}, "segments that are at least 1e-9 long in all", {}, {}};
}

double length_of(std::span<const Line> lines) {
    double whole = 0;
    for (const Line& line : lines) {
        for (std::size_t i = 1; i < line.size(); ++i) whole += length(line[i] - line[i - 1]);
    }
    return whole / static_cast<double>(lines.size());
}

Check check_drawing(const Drawing& drawing, const Limits& limits) {
    if (Check wrong = check_count(drawing.pictures.size(), 2, limits.pictures, "/pictures")) return wrong;
    if (Check wrong = check_lines(drawing.pictures, limits)) return within("/pictures", *wrong);
    const std::size_t nodes = drawing.pictures.front().size();
    if (Check wrong = check_count(nodes, 3, limits.nodes_per_chain, "/pictures/0")) return wrong;
    if (length_of(drawing.pictures) < kShortestDirection) return no_length("/pictures");
    if (!drawing.rest) return {};
    const Line& rest = *drawing.rest;
    if (rest.size() != nodes)
        return Error{ErrorCode::kConflict,
                     "/rest",
                     static_cast<double>(rest.size()),
                     "as many nodes as each picture has, " + std::to_string(nodes),
                     static_cast<double>(nodes),
                     static_cast<double>(nodes)};
    for (std::size_t i = 0; i < nodes; ++i) {
        if (Check wrong = check_position(rest[i], limits, "/rest/" + std::to_string(i))) return wrong;
    }
    return length_of({&rest, 1}) < kShortestDirection ? Check(no_length("/rest")) : Check{};
}

Check check_settings(const FitSettings& settings, const Limits& limits) {
    if (Check wrong = check_direction(settings.wind, limits, "/wind")) return wrong;
    if (Check wrong = check_direction(settings.up, limits, "/up")) return wrong;
    if (Check wrong = check_not_parallel(settings.wind, settings.up, "/wind", "up")) return wrong;
    return check_range(settings.steps, limits.fit_steps, "/steps");
}

}  // namespace

Check check_drawings(std::span<const Drawing> drawings, const Limits& limits) {
    if (Check wrong = check_count(drawings.size(), 1, limits.chains, "")) return wrong;
    std::size_t nodes = 0;
    for (std::size_t i = 0; i < drawings.size(); ++i) {
        if (Check wrong = check_drawing(drawings[i], limits)) return within("/" + std::to_string(i), *wrong);
        nodes += drawings[i].pictures.size() * drawings[i].pictures.front().size();
    }
    return check_total(nodes, limits.drawn_nodes, "nodes times pictures in all drawings", "");
}

Result<std::vector<Fit>> fit_waves(std::span<const Drawing> drawings, const FitSettings& settings,
                                   const Schedule* schedule, const Limits& limits, const ForEach& for_each,
                                   std::stop_token stop) {
    if (Check wrong = check_settings(settings, limits)) return *wrong;
    for (std::size_t i = 0; i < drawings.size() && schedule != nullptr; ++i) {
        const auto wanted = static_cast<std::size_t>(schedule->pictures), given = drawings[i].pictures.size();
        if (given != wanted)
            return Error{ErrorCode::kConflict,        "/drawn/" + std::to_string(i) + "/pictures",
                         static_cast<double>(given),  "as many pictures as the timing gives, " + std::to_string(wanted),
                         static_cast<double>(wanted), static_cast<double>(wanted)};
    }
    std::vector<Fit> fits(drawings.size());
    for_each(drawings.size(), [&](std::size_t i) {
        const Schedule even = schedule == nullptr ? even_schedule(drawings[i].pictures.size()) : Schedule{};
        fits[i] = fit_wave(drawings[i], settings, schedule == nullptr ? even : *schedule, limits, stop);
    });
    return fits;
}

}  // namespace tuftwave
