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
#include "fit_search.hpp"
#include "tuftwave/vector_checks.hpp"

namespace tuftwave {
namespace {

constexpr double kStillShare = 1e-9;  // of the rest length: pictures nearer than this are one picture
constexpr double kExactShare = 1e-9;  // the same for a wave's nodes: nothing comes nearer
constexpr int kMostCycles = 3;        // that are tried unasked
constexpr double kMuchNearer = 0.75;  // of the cost: what more waves per loop must gain, since noise favours them too

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
    chain.cycles = fit.cycles;
    const auto moved =
        *move_chains({&chain, 1}, motion_of(fit.wave, settings), schedule, limits, InOrder(), std::stop_token{});
    std::vector<Line> lines;
    const std::span<const Quat> rotations = moved.front().rotations;
    for (std::size_t at = 0; at < rotations.size(); at += fit.rest.size())
        lines.push_back(node_positions(chain, rotations.subspan(at, fit.rest.size())));
    return lines;
}

/// Numbers of waves per loop that the pictures can show.
std::vector<int> likely_cycles(const FitSettings& settings, std::size_t pictures) {
    if (settings.cycles) return {*settings.cycles};
    std::vector<int> cycles{1};
    for (int more = 2; more <= kMostCycles && 2 * static_cast<std::size_t>(more) < pictures; ++more)
        cycles.push_back(more);
    return cycles;
}

/// Looks for the wave with every likely number of cycles and sets what was found.
/// @return  whether the droop is known
bool find_fit(const Drawing& drawing, const FitSettings& settings, const Schedule& schedule, const Limits& limits,
              const std::stop_token& stop, Fit& fit) {
    SearchBudget budget{settings.steps, 0, stop};
    FoundWave best;
    for (const int cycles : likely_cycles(settings, drawing.pictures.size())) {
        const DrawnPlane plane(drawing, settings, schedule, cycles);
        const auto nodes = static_cast<double>(plane.nodes.size());
        const bool is_first = budget.taken == 0;
        if (!is_first && best.cost < kExactShare * kExactShare * nodes) break;
        if (!is_first && budget.is_spent()) fit.is_complete = false;
        if (budget.is_spent()) break;
        const FoundWave found = find_wave(plane, budget, limits);
        fit.is_complete = fit.is_complete && found.is_complete;
        if (!is_first && found.cost >= kMuchNearer * best.cost) continue;
        best = found;
        fit.cycles = cycles;
    }
    fit.wave = best.wave;
    fit.phase = best.phase;
    fit.steps = budget.taken;
    return best.is_droop_known;
}

Fit fit_wave(const Drawing& drawing, const FitSettings& settings, const Schedule& schedule, const Limits& limits,
             const std::stop_token& stop) {
    const DrawnPlane plane(drawing, settings, schedule, 1);
    Fit fit;
    fit.rest = plane.rest;
    fit.still = still_error(drawing.pictures, plane.rest_length);
    const bool is_still = fit.still.mean.position < kStillShare;
    const auto warn_if = [&](bool condition, FitWarning warning) {
        if (condition) fit.warnings.push_back(warning);
    };
    fit.wave.amplitude = 0;
    fit.cycles = settings.cycles.value_or(1);
    fit.is_complete = !stop.stop_requested();
    warn_if(plane.pictures() == 2, FitWarning::kTwoPictures);
    warn_if(is_still, FitWarning::kStill);
    if (fit.is_complete && (!is_still || !plane.is_centered)) {
        const bool is_droop_known = find_fit(drawing, settings, schedule, limits, stop, fit);
        warn_if(!is_droop_known, FitWarning::kDroopNotIdentifiable);
    }
    fit.error = *measure_error(moved_lines(fit, settings, schedule, limits), drawing.pictures, plane.rest_length);
    warn_if(!is_still && fit.error.mean.position >= fit.still.mean.position, FitWarning::kNoBetterThanStill);
    return fit;
}

Error no_length(const std::string& field) {
    return {ErrorCode::kDegenerate, field, {}, "segments that are at least 1e-9 long in all", {}, {}};
}

Check check_drawing(const Drawing& drawing, const Limits& limits) {
    if (Check wrong = check_count(drawing.pictures.size(), 2, limits.pictures, "/pictures")) return wrong;
    if (Check wrong = check_lines(drawing.pictures, limits)) return within("/pictures", *wrong);
    const std::size_t nodes = drawing.pictures.front().size();
    if (Check wrong = check_count(nodes, 3, limits.nodes_per_chain, "/pictures/0")) return wrong;
    if (mean_length(drawing.pictures) < kShortestDirection) return no_length("/pictures");
    if (!drawing.rest) return {};
    const Line& rest = *drawing.rest;
    if (rest.size() != nodes)
        return Error{ErrorCode::kConflict,
                     "/rest",
                     static_cast<double>(rest.size()),
                     "as many nodes as each picture has, " + std::to_string(nodes),
                     static_cast<double>(nodes),
                     static_cast<double>(nodes)};
    if (Check wrong = check_positions(rest, limits, "/rest")) return wrong;
    return mean_length({&rest, 1}) < kShortestDirection ? Check(no_length("/rest")) : Check{};
}

Check check_settings(const FitSettings& settings, const Limits& limits) {
    if (Check wrong = check_direction(settings.wind, limits, "/wind")) return wrong;
    if (Check wrong = check_direction(settings.up, limits, "/up")) return wrong;
    if (Check wrong = check_not_parallel(settings.wind, settings.up, "/wind", "up")) return wrong;
    if (settings.cycles) {
        if (Check wrong = check_range(*settings.cycles, limits.cycles, "/cycles")) return wrong;
    }
    return check_range(settings.steps, limits.fit_steps, "/steps");
}

/// Whether each drawing has as many pictures as the schedule, and enough for the cycles.
Check check_pictures(std::span<const Drawing> drawings, const FitSettings& settings, const Schedule* schedule) {
    for (std::size_t i = 0; i < drawings.size(); ++i) {
        const std::size_t given = drawings[i].pictures.size();
        const auto wanted = static_cast<double>(schedule == nullptr ? static_cast<int>(given) : schedule->pictures);
        if (wanted != static_cast<double>(given))
            return Error{ErrorCode::kConflict,
                         "/drawn/" + std::to_string(i) + "/pictures",
                         static_cast<double>(given),
                         "as many pictures as the timing gives, " + to_text(wanted),
                         wanted,
                         wanted};
        if (settings.cycles && *settings.cycles != 1 && 2 * static_cast<std::size_t>(*settings.cycles) >= given)
            return Error{ErrorCode::kConflict,
                         "/cycles",
                         static_cast<double>(*settings.cycles),
                         "1, or fewer than half of the " + std::to_string(given) + " pictures",
                         {},
                         {}};
    }
    return {};
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
    if (Check wrong = check_pictures(drawings, settings, schedule)) return *wrong;
    std::vector<Fit> fits(drawings.size());
    for_each(drawings.size(), [&](std::size_t i) {
        const Schedule even = schedule == nullptr ? even_schedule(drawings[i].pictures.size()) : Schedule{};
        fits[i] = fit_wave(drawings[i], settings, schedule == nullptr ? even : *schedule, limits, stop);
    });
    return fits;
}

}  // namespace tuftwave
