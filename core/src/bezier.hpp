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

/// The normal carried from `from` to another place without spin, not yet of unit length.
/// Source: double reflection (Wang et al. 2008).
TUFTWAVE_BODY Vec3 carried_normal(const CurveFrame& from, const Vec3& to, const Vec3& tangent) {
    const Vec3 v1 = to - from.point;
    const double c1 = dot(v1, v1);
    // A step that does not run along the tangent is rounding, or a cusp; reflecting in it would flip the normal.
    const bool forwards = dot(v1, from.tangent) > kLeastForwards * std::sqrt(c1);
    const Vec3 reflected_normal = from.normal - (2 / c1 * dot(v1, from.normal)) * v1;
    const Vec3 reflected_tangent = from.tangent - (2 / c1 * dot(v1, from.tangent)) * v1;
    const Vec3 v2 = tangent - reflected_tangent;
    const double c2 = dot(v2, v2);
    const double twice = 2 / c2 * dot(v2, reflected_normal);
    const Vec3 normal = reflected_normal - (c2 > 0 ? twice : 0.0) * v2;
    return rejected(chosen(forwards, normal, from.normal), tangent);  // rounding leaves a trace of tangent
}

/// Shorter than this, a carried normal has lost its direction.
inline constexpr double kLeastNormal = 1e-6;

}  // namespace tuftwave::bezier
