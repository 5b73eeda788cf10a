// Based on: K. Levenberg. A Method for the Solution of Certain Non-Linear Problems in Least Squares. 1944.
// D. Marquardt. An Algorithm for Least-Squares Estimation of Nonlinear Parameters. 1963.
// Differs: unknowns at a bound that they would leave are held; the work is counted in steps, never timed.
#include "fit_refine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tuftwave {
namespace {

constexpr double kFirstDamping = 1e-3;
constexpr double kLeastDamping = 1e-15;
constexpr double kMostDamping = 1e10;   // beyond it, steps are too short to change anything
constexpr double kSmallestStep = 1e-9;  // of the unknowns: the next step would be its square
constexpr double kSmallestGain = 1e-6;  // of the cost: what is left to gain is far below what noise hides
constexpr double kSmallestUnknown = 1e-3;
constexpr double kDiagonalFloor = 1e-9;  // of the largest, so that an unknown without effect stays put

bool is_small(const WaveUnknowns& step, const WaveUnknowns& unknowns) {
    for (std::size_t j = 0; j < step.size(); ++j) {
        if (std::abs(step[j]) > kSmallestStep * (std::abs(unknowns[j]) + kSmallestUnknown)) return false;
    }
    return true;
}

}  // namespace

Refinement::Refinement(const DrawnPlane& plane, const WaveBounds& bounds, const WaveUnknowns& start,
                       std::optional<double> lightness)
    : plane_(&plane),
      bounds_(&bounds),
      lightness_(lightness),
      unknowns_(tied(bounds.clamped(start))),
      misfit_(measure_misfit(plane, unknowns_, lightness)),
      damping_(kFirstDamping) {}

WaveUnknowns Refinement::tied(WaveUnknowns unknowns) const {
    if (lightness_) unknowns[kDroop] = droop_of(swing_of(unknowns), *lightness_);
    return unknowns;
}

std::optional<WaveUnknowns> Refinement::change() const {
    NormalEquations<5> damped = misfit_.equations;
    double largest = 0;
    for (std::size_t j = 0; j < 5; ++j) largest = std::max(largest, damped.matrix[j][j]);
    for (std::size_t j = 0; j < 5; ++j) {
        double& diagonal = damped.matrix[j][j];
        diagonal += damping_ * std::max(diagonal, kDiagonalFloor * largest) + 1e-300;
    }
    if (lightness_) damped.hold(kDroop);
    for (std::size_t j = 0; j < 5; ++j) {
        if (bounds_->is_blocked(unknowns_, j, misfit_.equations.right[j])) damped.hold(j);
    }
    return damped.solve();
}

void Refinement::step() {
    if (is_settled_) return;
    const std::optional<WaveUnknowns> by = change();
    if (by) {
        WaveUnknowns next = unknowns_;
        for (std::size_t j = 0; j < next.size(); ++j) next[j] += (*by)[j];
        next = tied(bounds_->clamped(next));
        Misfit misfit = measure_misfit(*plane_, next, lightness_);
        is_settled_ = is_small(*by, unknowns_);
        if (misfit.cost < misfit_.cost) {
            is_settled_ = is_settled_ || misfit_.cost - misfit.cost < kSmallestGain * misfit_.cost;
            unknowns_ = next;
            misfit_ = misfit;
            damping_ = std::max(damping_ / 10, kLeastDamping);
            return;
        }
    }
    damping_ *= 10;
    if (damping_ > kMostDamping) is_settled_ = true;
}

double Refinement::droop_deviation() const {
    const double rows = 2 * static_cast<double>(plane_->nodes.size()), unknowns = 5;
    const std::optional<double> variance = misfit_.equations.variance(kDroop);
    // What the drawing says at all: an angle per bone and picture, less the means that were taken out.
    const std::size_t angles = plane_->bones() * (plane_->pictures() - (plane_->is_centered ? 1 : 0));
    if (!variance || angles < 5) return std::numeric_limits<double>::infinity();
    return std::sqrt(*variance * misfit_.cost / (rows - unknowns));
}

}  // namespace tuftwave
