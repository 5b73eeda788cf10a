#pragma once

#include <array>
#include <cmath>

#include "tuftwave/curve.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/wide.hpp"

/// A cubic Bezier segment and the frames along it, for one place or, in loops, for many at once.
namespace tuftwave::bezier {

/// Nodes and weights of Gauss-Legendre quadrature on [0, 1].
inline constexpr std::array<double, 5> kGaussNodes{0.04691007703066800, 0.23076534494715845, 0.5, 0.76923465505284155,
                                                   0.95308992296933200};
inline constexpr std::array<double, 5> kGaussWeights{0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                                     0.23931433524968324, 0.11846344252809454};

/// A segment's derivative: constant + t linear + t^2 quadratic.
struct Velocity {
    Vec3 constant, linear, quadratic;

    /// Of the segment with these control points.
    static Velocity of(const Vec3& b0, const Vec3& b1, const Vec3& b2, const Vec3& b3) {
        const Vec3 first = b1 - b0, second = b2 - b1, third = b3 - b2;
        return {3 * first, 6 * (second - first), 3 * ((third - second) - (second - first))};
    }

    TUFTWAVE_BODY Vec3 at(double t) const { return constant + t * (linear + t * quadratic); }
    TUFTWAVE_BODY Vec3 change_at(double t) const { return linear + (2 * t) * quadratic; }
    TUFTWAVE_BODY double speed(double t) const { return length(at(t)); }

    /// From the segment's first point to that at `t`.
    TUFTWAVE_BODY Vec3 way_to(double t) const {
        return t * (constant + t * (0.5 * linear + (t * (1.0 / 3)) * quadratic));
    }

    /// Length between two parameters.
    TUFTWAVE_BODY double arc(double t0, double t1) const {
        const double step = t1 - t0;
        const double sum = kGaussWeights[0] * (speed(t0 + kGaussNodes[0] * step) + speed(t0 + kGaussNodes[4] * step)) +
                           kGaussWeights[1] * (speed(t0 + kGaussNodes[1] * step) + speed(t0 + kGaussNodes[3] * step)) +
                           kGaussWeights[2] * speed(t0 + kGaussNodes[2] * step);
        return sum * step;
    }
};

TUFTWAVE_BODY Vec3 chosen(bool first, const Vec3& a, const Vec3& b) {
    return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}

/// Cosine of the angle between a step and its first tangent, below which the step tells nothing: between two samples
/// it is 0.98 or more.
inline constexpr double kLeastForwards = 0.5;

/// A step from one frame's place to another's, as the two reflections that carry a normal along without spin. None of
/// it depends on the normal.
/// Source: double reflection (Wang et al. 2008).
struct Step {
    Vec3 first, second;                // what is reflected in
    double twice_first, twice_second;  // 2 / its square; 0 reflects nothing
    double coupling;                   // what the first reflection takes off along the second
    bool is_forwards;                  // false where the step tells nothing

    TUFTWAVE_BODY Step(const Vec3& from, const Vec3& from_tangent, const Vec3& to, const Vec3& tangent) {
        first = to - from;
        const double square = dot(first, first), forwards = dot(first, from_tangent);
        // A step that does not run along the tangent is rounding, or a cusp; reflecting in it would flip the normal.
        is_forwards = forwards > kLeastForwards * std::sqrt(square);
        twice_first = 2 / square;
        second = tangent - (from_tangent - (twice_first * forwards) * first);
        const double second_square = dot(second, second);
        const double twice = 2 / second_square;
        twice_second = second_square > 0 ? twice : 0.0;
        coupling = twice_first * dot(first, second);
    }
};

/// `v` reflected twice, both at once.
TUFTWAVE_BODY Vec3 carried(const Vec3& v, const Vec3& first, const Vec3& second, double twice_first,
                           double twice_second, double coupling) {
    const double along_first = dot(first, v), along_second = dot(second, v);
    return v - (twice_first * along_first) * first - (twice_second * (along_second - coupling * along_first)) * second;
}

/// The normal carried from `from` to another place without spin, not yet of unit length.
TUFTWAVE_BODY Vec3 carried_normal(const CurveFrame& from, const Vec3& to, const Vec3& tangent) {
    const Step step(from.point, from.tangent, to, tangent);
    const Vec3 normal =
        carried(from.normal, step.first, step.second, step.twice_first, step.twice_second, step.coupling);
    return rejected(chosen(step.is_forwards, normal, from.normal), tangent);  // rounding leaves a trace of tangent
}

/// Shorter than this, a carried normal has lost its direction.
inline constexpr double kLeastNormal = 1e-6;

}  // namespace tuftwave::bezier
