#include "character/affine.hpp"

#include <cmath>

namespace tuftwave::server::character {
namespace {

constexpr double kSquare = 1e-3;  // cosine of two axes that still count as perpendicular: 0.06 degrees

Vec3 turned(const Affine& a, const Vec3& v) { return v.x * a.x + v.y * a.y + v.z * a.z; }

}  // namespace

Affine operator*(const Affine& a, const Affine& b) {
    return {turned(a, b.x), turned(a, b.y), turned(a, b.z), transformed(a, b.origin)};
}

Vec3 transformed(const Affine& a, const Vec3& point) { return turned(a, point) + a.origin; }

Affine to_affine(const Placement& placement) {
    const auto& [translation, rotation, scale] = placement;
    return {scale.x * rotated(rotation, {1, 0, 0}), scale.y * rotated(rotation, {0, 1, 0}),
            scale.z * rotated(rotation, {0, 0, 1}), translation};
}

std::optional<Placement> to_placement(const Affine& a) {
    const Vec3 scale{length(a.x), length(a.y), length(a.z)};
    if (!(scale.x > 0 && scale.y > 0 && scale.z > 0)) return {};
    const Vec3 x = a.x / scale.x, y = a.y / scale.y, z = a.z / scale.z;
    const bool is_square =
        std::abs(dot(x, y)) < kSquare && std::abs(dot(y, z)) < kSquare && std::abs(dot(z, x)) < kSquare;
    if (!is_square || dot(cross(x, y), z) <= 0) return {};
    const Vec3 upright = normalized(rejected(y, x));
    return Placement{a.origin, rotation_from_axes(x, upright, cross(x, upright)), scale};
}

}  // namespace tuftwave::server::character
