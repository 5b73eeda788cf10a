#pragma once

#include <array>
#include <cstddef>

#include "tuftwave/curve.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/wide.hpp"

namespace tuftwave {

/// How far from the wanted length a place may be, as a share of its piece: a nanometre on a kilometre.
inline constexpr double kArcTolerance = 1e-12;

/// As many vectors as a search has places, axis by axis.
template <std::size_t kCount>
struct VectorRows {
    alignas(64) std::array<double, kCount> x, y, z;

    TUFTWAVE_BODY Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    TUFTWAVE_BODY void set(std::size_t i, const Vec3& v) {
        x[i] = v.x;
        y[i] = v.y;
        z[i] = v.z;
    }
};

/// Places that are looked for on a curve by their arc length, all at once. Each lies on a piece of a Bezier segment,
/// at whose start the frame is known.
struct PlaceSearch {
    static constexpr std::size_t kMost = 64;
    /// Neighbours often lie on one piece: what they share is written to so many places at once, and the next piece's
    /// overwrites what was too much. There is room for that behind the last place.
    static constexpr std::size_t kRun = 2;
    using Rows = VectorRows<kMost + kRun>;
    using Row = std::array<double, kMost + kRun>;

    Rows start;                        ///< the segment's first point
    Rows constant, linear, quadratic;  ///< of its velocity
    alignas(64) Row t0, t1;            ///< where the piece starts and ends
    alignas(64) Row speed0, speed1;    ///< there
    alignas(64) Row wanted, whole;     ///< metres from its start to the place, and to its end
    Rows point, tangent, normal;       ///< the frame at its start; find_frames() replaces it by the place's
    alignas(64) Row t;                 ///< found: the parameter
    alignas(64) Row missed;            ///< found: 0 where t is as exact as doubles are, 1 where it may not be
    alignas(64) Row normal_size;       ///< found: 0 where the frame has no normal

    CurveFrame frame(std::size_t k) const { return {point[k], tangent[k], normal[k]}; }
    void set_frame(std::size_t k, const CurveFrame& frame) {
        point.set(k, frame.point);
        tangent.set(k, frame.tangent);
        normal.set(k, frame.normal);
    }

    /// Writes what a piece has to the places from `k` on, as many as kRun.
    TUFTWAVE_BODY static void put(Row& row, std::size_t k, double value) {
        for (std::size_t j = k; j < k + kRun; ++j) row[j] = value;
    }
    TUFTWAVE_BODY static void put(Rows& rows, std::size_t k, const Vec3& v) {
        put(rows.x, k, v.x);
        put(rows.y, k, v.y);
        put(rows.z, k, v.z);
    }

    /// Finds `t` of the first `count` places from guesses by cubic interpolation, in one or two steps of the third
    /// order.
    void find_parameters(std::size_t count, Vectors vectors);

    /// Replaces each frame by that of its place, at `t`.
    void find_frames(std::size_t count, Vectors vectors);

    void copy_frames(std::size_t count, const FrameRows& to) const;
};

}  // namespace tuftwave
