#pragma once

#include "tuftwave/limits.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/result.hpp"

namespace tuftwave {

/// The head that tufts grow on, in glTF axes, metres.
struct Head {
    Vec3 center;                   ///< H, the head's reference point
    Vec3 up{0, 1, 0};              ///< any length but zero
    Vec3 front{0, 0, 1};           ///< where the face looks; not parallel to up
    double root_depth = 0.01;      ///< f: how far a tuft's root is sunk towards the center, metres
    double diameter_at_100 = 0.1;  ///< the diameter of a tuft whose d is 100, metres
};

/// @errors  not_finite, out_of_range, degenerate (up zero; front zero or parallel to up)
Check check_head(const Head& head, const Limits& limits);

/// P_0: the point under the scalp where a tuft with its first drawn point at `root` really begins.
/// @param root  not the head's center
/// @return  `root` moved towards the center by root_depth, but never past the center
/// Source: Shimosoyama, Yamamoto and Noma, section 3.1.
Vec3 sunk_root(const Head& head, const Vec3& root);

}  // namespace tuftwave
