// Based on: our own choice of starts; the refinement is that of Levenberg and Marquardt.
// Differs: of the droop only what the drawing tells is used, see core/README.md.
#include "fit_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include "fit_refine.hpp"
#include "fit_start.hpp"
#include "tuftwave/elementary.hpp"
#include "wave_unknowns.hpp"

namespace tuftwave {
namespace {

constexpr int kTrialSteps = 8;   // enough to tell which starts lead somewhere
constexpr int kFinalSteps = 40;  // enough to tell which of the nearest is the best
constexpr std::size_t kFinalists = 4;
constexpr double kGuesses[] = {1.2, 0.4, 4};  // of the lightness, where only a refinement can tell it
constexpr double kSure = 3;                   // standard deviations by which a droop must differ from none

bool is_nearer(const Refinement& a, const Refinement& b) { return a.cost() < b.cost(); }

/// Takes at most `most` steps, and none beyond the budget.
void follow(Refinement& refinement, int most, SearchBudget& budget) {
    for (int i = 0; i < most && !refinement.is_settled() && !budget.is_spent(); ++i, ++budget.taken) refinement.step();
}

/// The likeliest waves, a few steps on, the nearest first. A relative motion hardly shows its droop: there each is
/// tried with several lightnesses.
std::vector<Refinement> trials(const DrawnPlane& plane, const WaveBounds& bounds, SearchBudget& budget) {
    std::vector<std::optional<double>> guesses{std::nullopt};
    if (plane.is_centered) guesses.assign(std::begin(kGuesses), std::end(kGuesses));
    std::vector<Refinement> trials;
    for (const WaveUnknowns& start : likely_waves(plane, bounds)) {
        for (const std::optional<double> lightness : guesses) {
            trials.emplace_back(plane, bounds, start, lightness);
            follow(trials.back(), kTrialSteps, budget);
        }
    }
    std::stable_sort(trials.begin(), trials.end(), is_nearer);
    return trials;
}

/// The best wave whose droop is free.
Refinement free_wave(const DrawnPlane& plane, const WaveBounds& bounds, SearchBudget& budget) {
    std::vector<Refinement> finalists;
    for (const Refinement& trial : trials(plane, bounds, budget)) {
        finalists.emplace_back(plane, bounds, trial.unknowns(), std::nullopt);
        follow(finalists.back(), kFinalSteps, budget);
        if (finalists.size() == kFinalists) break;
    }
    Refinement best = *std::min_element(finalists.begin(), finalists.end(), is_nearer);
    follow(best, budget.allowed, budget);
    return best;
}

/// The lightness of a wave whose droop the drawing does not tell, within the limits. In relative mode, which hardly
/// shows it, the one nearest to the default among those that fit as well.
/// @param uncertain  by how much the droop may differ
double likely_lightness(const DrawnPlane& plane, const WaveUnknowns& wave, double uncertain, const Limits& limits) {
    const double swing = swing_of(wave), droop = wave[kDroop];
    const double likely =
        plane.is_centered ? std::clamp(droop_of(swing, Wave{}.lightness), droop - uncertain, droop + uncertain) : droop;
    const Range range = lightness_range(swing, limits);
    const double size = likely == 0 ? range.maximum : std::abs(swing / likely);
    return (likely < 0 ? -1 : 1) * std::clamp(size, range.minimum, range.maximum);
}

}  // namespace

FoundWave find_wave(const DrawnPlane& plane, SearchBudget& budget, const Limits& limits) {
    const WaveBounds bounds(plane, limits);
    Refinement best = free_wave(plane, bounds, budget);
    FoundWave found;
    found.is_complete = best.is_settled();
    const double swing = swing_of(best.unknowns()), droop = best.unknowns()[kDroop];
    const double uncertain = kSure * best.droop_deviation();
    double lightness = droop == 0 ? 0 : swing / droop;
    found.is_droop_known =
        std::abs(droop) > uncertain && is_within(std::abs(lightness), lightness_range(swing, limits));
    if (!found.is_droop_known) {
        lightness = likely_lightness(plane, best.unknowns(), uncertain, limits);
        best = Refinement(plane, bounds, best.unknowns(), lightness);
        follow(best, budget.allowed, budget);
        found.is_complete = found.is_complete && best.is_settled();
    }
    found.wave = wave_of(best.unknowns(), lightness, limits);
    found.phase = elementary::atan2(best.unknowns()[kSine], best.unknowns()[kCosine]);
    found.cost = best.cost();
    return found;
}

}  // namespace tuftwave
