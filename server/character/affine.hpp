#pragma once

#include <optional>

#include "tuftwave/math.hpp"

namespace tuftwave::server::character {

/// A 3x3 matrix by its columns, and a translation: what glTF's node transforms and inverse bind matrices are.
struct Affine {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin;
};

/// `b`, then `a`.
Affine operator*(const Affine& a, const Affine& b);

Vec3 transformed(const Affine& a, const Vec3& point);

/// A translation, a rotation and a scale along the axes before it.
struct Placement {
    Vec3 translation;
    Quat rotation;
    Vec3 scale{1, 1, 1};
};

Affine to_affine(const Placement& placement);

/// The same as translation, rotation and scale; nothing if it mirrors, shears or flattens.
std::optional<Placement> to_placement(const Affine& a);

}  // namespace tuftwave::server::character
