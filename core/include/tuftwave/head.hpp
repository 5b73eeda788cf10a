#pragma once

#include "tuftwave/limits.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/result.hpp"
#include "tuftwave/scalp_shape.hpp"

namespace tuftwave {

/// The head that tufts grow on, in glTF axes, metres.
struct Head {
    Vec3 center;                   ///< H, the head's reference point
    Vec3 up{0, 1, 0};              ///< any length but zero
    Vec3 front{0, 0, 1};           ///< where the face looks; not parallel to up
    double root_depth = 0.01;      ///< f: how far a tuft's root is sunk towards the center, metres
    double diameter_at_100 = 0.1;  ///< the diameter of a tuft whose d is 100, metres
    ScalpShape scalp;              ///< what filled tufts are put on
};

/// @errors  not_finite, out_of_range, degenerate (up zero; front zero or parallel to up; the center outside of an
///          ellipsoid), those of check_scalp_shape below "/scalp"
Check check_head(const Head& head, const Limits& limits);

/// P_0: the point under the scalp where a tuft with its first drawn point at `root` really begins.
/// @param root  not the head's center
/// @return  `root` moved towards the center by root_depth, but never past the center
/// Source: Shimosoyama, Yamamoto and Noma, section 3.1.
Vec3 sunk_root(const Head& head, const Vec3& root);

/// The axes of the tufts paper: the origin is the head's center, X is the character's left, the face looks towards -Y,
/// Z is up. Everything about azimuth and elevation is said in this frame, and only here.
class HeadFrame {
  public:
    explicit HeadFrame(const Head& head);

    Vec3 to_head(const Vec3& model_point) const;
    Vec3 to_model(const Vec3& head_point) const;

  private:
    Vec3 center_, left_, back_, up_;
};

/// A direction from the head's center, or of a piece of a stroke, in the head's frame.
struct Bearing {
    double azimuth = 0;    ///< radians, counter-clockwise seen from above; 0 is the character's left, -pi/2 the face
    double elevation = 0;  ///< radians, -pi/2 to pi/2
};

/// @return  azimuth in [-pi, pi]; 0 for a vertical `v`
Bearing bearing_of(const Vec3& v);

/// The unit vector in that direction.
Vec3 vector_towards(const Bearing& bearing);

/// Whether `v` has no azimuth: its horizontal part is less than 1e-9 of its length.
bool is_vertical(const Vec3& v);

/// The turn about the head's center by `by`: within the meridian of `azimuth` by by.elevation, then about the up axis
/// by by.azimuth.
Quat turn_along_meridian(double azimuth, const Bearing& by);

/// Whether hair grows at a root in that direction: above the face and down to the neck, borders excluded.
/// Source: Shimosoyama, Yamamoto and Noma, eq. (8).
bool is_within_hairline(const Bearing& root);

/// Angles nearer than this count as equal where an equation sets a strict bound, radians: 0.1 nanometres on a head, far
/// above rounding.
inline constexpr double kSameAngle = 1e-9;

}  // namespace tuftwave
