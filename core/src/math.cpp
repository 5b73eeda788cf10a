// Based on: S. W. Shepperd. Quaternion from rotation matrix. 1978. The largest component first.
#include "tuftwave/math.hpp"

#include "tuftwave/elementary.hpp"

#include <array>
#include <cmath>

namespace tuftwave {
namespace {

/// Sine of the angle from opposite, below which no axis is preferred to the given one: a nanometre on a metre, which
/// a mesh of floats does not show (6e-8), but well above what rounding leaves of a unit vector (1e-16).
constexpr double kOpposite = 1e-9;

/// Radians, below which a turn is none; far below a double's resolution of any position, and above the lengths
/// (1e-154) whose squares vanish.
constexpr double kNoTurn = 1e-100;

}  // namespace

Vec3 any_perpendicular(const Vec3& a) {
    // Crossing with the axis that `a` is farthest from loses the least.
    const double x = std::abs(a.x), y = std::abs(a.y), z = std::abs(a.z);
    if (x <= y && x <= z) return normalized(Vec3{0, a.z, -a.y});
    if (y <= z) return normalized(Vec3{-a.z, 0, a.x});
    return normalized(Vec3{a.y, -a.x, 0});
}

Quat turn_about(const Vec3& axis, const double angle) {
    const elementary::SinCos half = elementary::sincos(angle / 2);
    return {half.sin * axis.x, half.sin * axis.y, half.sin * axis.z, half.cos};
}

Quat shortest_turn(const Vec3& from, const Vec3& to, const Vec3& opposite_axis, const double part) {
    // The difference d and the sum h of the two are 2 sin and 2 cos of half the angle long. Crossing with the shorter
    // of them instead of with `to`, which gives the same vector, keeps all digits of a small angle or a small rest.
    const double cosine = dot(from, to);
    const Vec3 difference = to - from, sum = to + from;
    const bool acute = cosine >= 0;
    const Vec3 normal = cross(from, acute ? difference : sum);
    const double sine = length(normal);

    if (!acute && sine < kOpposite) return turn_about(opposite_axis, part * kPi);
    if (part != 1) {
        if (sine < kNoTurn) return {};
        return turn_about(normal / sine, part == 0 ? 0 : part * elementary::atan2(sine, cosine));
    }
    // |normal| = |d| |h| / 2, so that both forms below are (axis sin(angle/2), cos(angle/2)).
    const double half_sine = length(difference) / 2, half_cosine = length(sum) / 2;
    const Vec3 vector = acute ? normal / (2 * half_cosine) : (half_sine / sine) * normal;
    return normalized(Quat{vector.x, vector.y, vector.z, acute ? half_cosine : sine / (2 * half_sine)});
}

Quat rotation_from_axes(const Vec3& x_axis, const Vec3& y_axis, const Vec3& z_axis) {
    // The diagonal gives four times the square of each component; dividing by the largest is always safe.
    const double x = x_axis.x, y = y_axis.y, z = z_axis.z;
    const double yz = y_axis.z + z_axis.y, zx = z_axis.x + x_axis.z, xy = x_axis.y + y_axis.x;
    const double turn_x = y_axis.z - z_axis.y, turn_y = z_axis.x - x_axis.z, turn_z = x_axis.y - y_axis.x;
    const double trace = x + y + z;
    if (trace >= x && trace >= y && trace >= z) return normalized(Quat{turn_x, turn_y, turn_z, 1 + trace});
    if (x >= y && x >= z) return normalized(Quat{1 + x - y - z, xy, zx, turn_x});
    if (y >= z) return normalized(Quat{xy, 1 + y - z - x, yz, turn_y});
    return normalized(Quat{zx, yz, 1 + z - x - y, turn_z});
}

std::array<double, 16> inverse_rigid_matrix(const Quat& rotation, const Vec3& origin) {
    const Quat back = inverse(rotation);
    const Vec3 x = rotated(back, {1, 0, 0}), y = rotated(back, {0, 1, 0}), z = rotated(back, {0, 0, 1});
    const Vec3 move = -rotated(back, origin);
    return {x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, move.x, move.y, move.z, 1};
}

}  // namespace tuftwave
