#pragma once

#include <array>
#include <cmath>

namespace tuftwave {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kRadiansPerDegree = kPi / 180;

/// A point or direction, metres or unitless; right-handed, Y up.
struct Vec3 {
    double x = 0, y = 0, z = 0;

    friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr Vec3 operator*(const Vec3& a, double s) { return s * a; }
constexpr Vec3 operator/(const Vec3& a, double s) { return {a.x / s, a.y / s, a.z / s}; }

constexpr double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }

/// @param a  not zero
inline Vec3 normalized(const Vec3& a) { return a / length(a); }

/// The part of `a` perpendicular to the unit vector `unit`.
constexpr Vec3 rejected(const Vec3& a, const Vec3& unit) { return a - dot(a, unit) * unit; }

/// Some unit vector perpendicular to the unit vector `a`, always the same one.
Vec3 any_perpendicular(const Vec3& a);

inline bool is_finite(const Vec3& a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

/// A rotation as a unit quaternion, x y z w as in glTF.
struct Quat {
    double x = 0, y = 0, z = 0, w = 1;

    friend constexpr bool operator==(const Quat&, const Quat&) = default;
};

/// The rotation `b` followed by the rotation `a`.
constexpr Quat operator*(const Quat& a, const Quat& b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
constexpr Quat inverse(const Quat& q) { return {-q.x, -q.y, -q.z, q.w}; }
constexpr Quat operator-(const Quat& q) { return {-q.x, -q.y, -q.z, -q.w}; }
constexpr double dot(const Quat& a, const Quat& b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }

/// @param q  not zero
inline Quat normalized(const Quat& q) {
    const double norm = std::sqrt(dot(q, q));
    return {q.x / norm, q.y / norm, q.z / norm, q.w / norm};
}

/// `v` turned by `q`.
constexpr Vec3 rotated(const Quat& q, const Vec3& v) {
    const Vec3 u{q.x, q.y, q.z};
    const Vec3 t = 2 * cross(u, v);
    return v + q.w * t + cross(u, t);
}

/// The turn by `angle` radians about the unit vector `axis`, counter-clockwise seen from its tip.
Quat turn_about(const Vec3& axis, double angle);

/// The share `part` of the shortest turn that takes the unit vector `from` to the unit vector `to`.
/// @param part  0 is no turn, 1 the whole turn
/// @param opposite_axis  unit axis to turn about where `to` is opposite to `from`, perpendicular to both
Quat shortest_turn(const Vec3& from, const Vec3& to, const Vec3& opposite_axis, double part = 1);

/// The rotation whose columns are the three orthonormal, right-handed axes.
Quat rotation_from_axes(const Vec3& x_axis, const Vec3& y_axis, const Vec3& z_axis);

/// Column-major 4x4 matrix of the rigid motion that inverts "rotate by `rotation`, then move by `origin`".
std::array<double, 16> inverse_rigid_matrix(const Quat& rotation, const Vec3& origin);

}  // namespace tuftwave
