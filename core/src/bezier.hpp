#pragma once

#include <array>
#include <cmath>

#include "tuftwave/curve.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/wide.hpp"

/// A cubic Bezier segment and the frames along it, for one place or, in loops, for many at once.
namespace tuftwave::bezier {

/// The differences of neighbouring control points; the curve's direction depends on them alone.
struct Hodograph {
    Vec3 first, second, third;

    TUFTWAVE_BODY Vec3 derivative(double t) const {
        const double u = 1 - t;
        return 3 * u * u * first + 6 * u * t * second + 3 * t * t * third;
    }

    TUFTWAVE_BODY double speed(double t) const { return length(derivative(t)); }

    /// Length between two parameters, by Gauss-Legendre quadrature with five nodes.
    TUFTWAVE_BODY double arc(double t0, double t1) const {
        const double step = t1 - t0;
        const double sum = 0.11846344252809454 * speed(t0 + 0.04691007703066800 * step) +
                           0.23931433524968324 * speed(t0 + 0.23076534494715845 * step) +
                           0.28444444444444444 * speed(t0 + 0.5 * step) +
                           0.23931433524968324 * speed(t0 + 0.76923465505284155 * step) +
                           0.11846344252809454 * speed(t0 + 0.95308992296933200 * step);
        return sum * step;
    }
};

TUFTWAVE_BODY Vec3 point(const Vec3& b0, const Vec3& b1, const Vec3& b2, const Vec3& b3, double t) {
    const double u = 1 - t;
    return u * u * u * b0 + 3 * u * u * t * b1 + 3 * u * t * t * b2 + t * t * t * b3;
}

TUFTWAVE_BODY Vec3 chosen(bool first, const Vec3& a, const Vec3& b) {
    return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}

/// Cosine of the angle between a step and its first tangent, below which the step tells nothing: between two samples
/// it is 0.98 or more.
inline constexpr double kLeastForwards = 0.5;

/// A step from one frame's place to another's, as the two reflections that carry a normal along without spin.
/// Source: double reflection (Wang et al. 2008).
struct Step {
    Vec3 first, second;                // what is reflected in
    double twice_first, twice_second;  // 2 / its square; 0 reflects nothing
    bool is_forwards;                  // false where the step tells nothing

    TUFTWAVE_BODY Step(const Vec3& from, const Vec3& from_tangent, const Vec3& to, const Vec3& tangent) {
        first = to - from;
        const double square = dot(first, first);
        // A step that does not run along the tangent is rounding, or a cusp; reflecting in it would flip the normal.
        is_forwards = dot(first, from_tangent) > kLeastForwards * std::sqrt(square);
        twice_first = 2 / square;
        second = tangent - (from_tangent - (twice_first * dot(first, from_tangent)) * first);
        const double second_square = dot(second, second);
        const double twice = 2 / second_square;
        twice_second = second_square > 0 ? twice : 0.0;
    }
};

/// @param twice  2 / the square of `in`; 0 reflects nothing
TUFTWAVE_BODY Vec3 reflected(const Vec3& v, const Vec3& in, double twice) { return v - (twice * dot(in, v)) * in; }

/// The normal carried from `from` to another place without spin, not yet of unit length.
TUFTWAVE_BODY Vec3 carried_normal(const CurveFrame& from, const Vec3& to, const Vec3& tangent) {
    const Step step(from.point, from.tangent, to, tangent);
    const Vec3 once = reflected(from.normal, step.first, step.twice_first);
    const Vec3 normal = reflected(once, step.second, step.twice_second);
    return rejected(chosen(step.is_forwards, normal, from.normal), tangent);  // rounding leaves a trace of tangent
}

/// Shorter than this, a carried normal has lost its direction.
inline constexpr double kLeastNormal = 1e-6;

}  // namespace tuftwave::bezier
