#pragma once

#include <cstddef>
#include <cstdint>

#include "tuftwave/elementary.hpp"
#include "tuftwave/scalp_shape.hpp"

/// Scalps with a known shape.
namespace tuftwave::test {

/// A closed sphere of triangles. @param bands  from pole to pole, at least 2
inline ScalpMesh sphere_mesh(const Vec3& center, const double radius, const std::uint32_t bands) {
    ScalpMesh mesh;
    const std::uint32_t around = 2 * bands, rings = bands - 1;
    for (std::uint32_t ring = 1; ring <= rings; ++ring) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const auto tilt = elementary::sincos(kPi * ring / bands), turn = elementary::sincos(2 * kPi * i / around);
            mesh.positions.push_back(center + radius * Vec3{tilt.sin * turn.cos, tilt.cos, tilt.sin * turn.sin});
        }
    }
    const std::uint32_t top = rings * around, bottom = top + 1;
    mesh.positions.push_back(center + Vec3{0, radius, 0});
    mesh.positions.push_back(center - Vec3{0, radius, 0});
    for (std::uint32_t i = 0; i < around; ++i) {
        const std::uint32_t next = (i + 1) % around, last = top - around;
        mesh.triangles.push_back({i, top, next});
        for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
            const std::uint32_t a = ring * around + i, b = ring * around + next;
            mesh.triangles.push_back({a, b, b + around});
            mesh.triangles.push_back({a, b + around, a + around});
        }
        mesh.triangles.push_back({last + i, last + next, bottom});
    }
    return mesh;
}

}  // namespace tuftwave::test
