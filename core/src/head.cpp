// Based on: Shimosoyama, Yamamoto, Noma. NPR Hair Modeling by Controlling the Shape of Tufts. Section 3.1; section 4,
// angles about the head; section 4.2, equation (8).
// Differs: the depth is clamped so that a root never passes the center.
#include "tuftwave/head.hpp"

#include <cmath>

#include "tuftwave/elementary.hpp"
#include "tuftwave/vector_checks.hpp"

namespace tuftwave {
namespace {

/// Horizontal part of a vertical direction, as a share of its length.
constexpr double kVertical = 1e-9;

/// An angle in (-pi, pi].
double wrapped(double angle) {
    const double turns = std::ceil(angle / (2 * kPi) - 0.5);
    return angle - 2 * kPi * turns;
}

Check check_center_inside(const Head& head) {
    const auto* ellipsoid = std::get_if<ScalpEllipsoid>(&head.scalp);
    if (ellipsoid == nullptr || !ellipsoid->center) return {};
    const Vec3 middle = HeadFrame(head).to_head(*ellipsoid->center);
    const Vec3& radii = ellipsoid->radii;  // width, height, depth
    if (length({middle.x / radii.x, middle.z / radii.y, middle.y / radii.z}) < 1) return {};
    return Error{ErrorCode::kDegenerate, "/scalp/ellipsoid", {}, "an ellipsoid with head.center inside", {}, {}};
}

}  // namespace

Check check_head(const Head& head, const Limits& limits) {
    if (Check wrong = check_position(head.center, limits, "/center")) return wrong;
    if (Check wrong = check_direction(head.up, limits, "/up")) return wrong;
    if (Check wrong = check_direction(head.front, limits, "/front")) return wrong;
    if (Check wrong = check_not_parallel(head.front, head.up, "/front", "up")) return wrong;
    if (Check wrong = check_range(head.root_depth, limits.root_depth, "/root_depth")) return wrong;
    if (Check wrong = check_range(head.diameter_at_100, limits.diameter_at_100, "/diameter_at_100")) return wrong;
    if (Check wrong = check_scalp_shape(head.scalp, limits)) return within("/scalp", *wrong);
    return check_center_inside(head);
}

Vec3 sunk_root(const Head& head, const Vec3& root) {
    const Vec3 inward = head.center - root;
    const double distance = length(inward);
    if (head.root_depth >= distance) return head.center;
    return root + (head.root_depth / distance) * inward;
}

HeadFrame::HeadFrame(const Head& head) : center_(head.center), up_(normalized(head.up)) {
    back_ = -normalized(rejected(normalized(head.front), up_));
    left_ = cross(back_, up_);
}

Vec3 HeadFrame::to_head(const Vec3& model_point) const {
    const Vec3 from_center = model_point - center_;
    return {dot(from_center, left_), dot(from_center, back_), dot(from_center, up_)};
}

Vec3 HeadFrame::to_model(const Vec3& head_point) const {
    return center_ + head_point.x * left_ + head_point.y * back_ + head_point.z * up_;
}

Bearing bearing_of(const Vec3& v) {
    const double horizontal = std::sqrt(v.x * v.x + v.y * v.y);
    return {is_vertical(v) ? 0 : elementary::atan2(v.y, v.x), elementary::atan2(v.z, horizontal)};
}

Vec3 vector_towards(const Bearing& bearing) {
    const elementary::SinCos azimuth = elementary::sincos(bearing.azimuth);
    const elementary::SinCos elevation = elementary::sincos(bearing.elevation);
    return {elevation.cos * azimuth.cos, elevation.cos * azimuth.sin, elevation.sin};
}

bool is_vertical(const Vec3& v) { return v.x * v.x + v.y * v.y < kVertical * kVertical * dot(v, v) || dot(v, v) == 0; }

Quat turn_along_meridian(double azimuth, const Bearing& by) {
    const elementary::SinCos facing = elementary::sincos(azimuth);
    return turn_about({0, 0, 1}, by.azimuth) * turn_about({facing.sin, -facing.cos, 0}, by.elevation);
}

bool is_within_hairline(const Bearing& root) {
    const double azimuth = wrapped(root.azimuth);
    const bool is_above_face = azimuth > -5 * kPi / 6 + kSameAngle && azimuth < -kPi / 6 - kSameAngle;
    return root.elevation > (is_above_face ? 0 : -kPi / 3) + kSameAngle;  // eq. (8)
}

}  // namespace tuftwave
