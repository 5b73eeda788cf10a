// Based on: our own. Normals come from the grid itself, so that taper, twist, flatness and cut-back bends are all in
// them.
#include "ring_normals.hpp"

#include <algorithm>
#include <cstddef>

#include "tuftwave/vector_checks.hpp"

namespace tuftwave {
namespace {

/// Share of a ring's area below which a piece of the grid has none.
constexpr double kLeastArea = 1e-9;

/// The direction of a piece's normal, zero where the piece has no area. @param area  as a vector along the normal
Vec3 direction_of(const Vec3& area, double least_area) {
    const double size = length(area);
    return size > least_area ? area / size : Vec3{};
}

/// Straight away from the middle.
Vec3 outward(const Ring& ring, const Corners& corners, std::size_t corner) {
    const Vec3 offset = corners.offset(ring, corner);
    const double distance = length(offset);
    return distance > 0 ? offset / distance : ring.frame.normal;
}

}  // namespace

RingCorners gathered(const Vec3& place) {
    RingCorners all;
    all.fill(place);
    return all;
}

RingCorners standing(const Ring& ring, const Corners& corners, std::span<const float> reach) {
    RingCorners all;
    for (std::size_t j = 0; j < corners.count(); ++j) {
        const double share = reach.empty() ? 1 : static_cast<double>(reach[j]);
        all[j] = ring.frame.point + share * corners.offset(ring, j);
    }
    return all;
}

void write_normals(const Ring& ring, const Corners& corners, const RingNeighbours& rings, std::span<float> normals) {
    const auto& [before, here, after] = rings;
    const std::size_t sides = corners.count();
    const double least_area = kLeastArea * ring.half_width * ring.half_width;
    for (std::size_t j = 0; j < sides; ++j) {
        const Vec3 around = here[(j + 1) % sides] - here[(j + sides - 1) % sides];
        const Vec3 first = direction_of(cross(around, here[j] - before[j]), least_area),
                   second = direction_of(cross(around, after[j] - here[j]), least_area);
        const Vec3 sum = first + second;
        const double size = length(sum);
        const Vec3 normal = size > kSmallestSine ? sum / size : outward(ring, corners, j);
        normals[3 * j] = static_cast<float>(normal.x);
        normals[3 * j + 1] = static_cast<float>(normal.y);
        normals[3 * j + 2] = static_cast<float>(normal.z);
    }
    std::copy_n(normals.begin(), 3, &normals[3 * sides]);
}

}  // namespace tuftwave
