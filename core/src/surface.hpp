#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "corners.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/tuft.hpp"
#include "tuftwave/wide.hpp"

namespace tuftwave {

/// Where the corners of a ring stand, metres. The last one is there again before the first, and the first behind the
/// last, so that each has both neighbours beside it.
struct RingCorners {
    alignas(64) std::array<double, kMostSides + 2> x, y, z;

    Vec3 operator[](std::size_t corner) const { return {x[corner + 1], y[corner + 1], z[corner + 1]}; }

    /// All corners at one place.
    void gather(const Vec3& place);

    /// @param reach  share of each corner's distance from the middle that is kept; empty where all of it is
    void stand(const Ring& ring, const Corners& corners, std::span<const float> reach, Vectors vectors);
};

/// Three rings in a row, of which the middle one gets its normals.
struct RingNeighbours {
    const RingCorners &before, &here, &after;
};

/// Writes a ring's corners and their normals, the first corner once more at the end.
/// The normal is the one halfway between the pieces before and after, however long they are: at a sharp edge it looks
/// away from both. Straight away from the middle where neither has an area.
/// @param positions, normals  3 (sides + 1) each
void write_corners(const Ring& ring, const Corners& corners, const RingNeighbours& rings, Vectors vectors,
                   std::span<float> positions, std::span<float> normals);

}  // namespace tuftwave
