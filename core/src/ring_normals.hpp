#pragma once

#include <array>
#include <span>

#include "corners.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/tuft.hpp"

namespace tuftwave {

/// Where the corners of a ring stand, metres; as many as the ring has are used.
using RingCorners = std::array<Vec3, kMostSides>;

/// All corners at one place.
RingCorners gathered(const Vec3& place);

/// @param reach  share of each corner's distance from the middle that is kept; empty where all of it is
RingCorners standing(const Ring& ring, const Corners& corners, std::span<const float> reach);

/// Three rings in a row, of which the middle one gets its normals.
struct RingNeighbours {
    RingCorners before, here, after;
};

/// Writes the normals of a ring's corners, the first once more at the end.
/// The normal is the one halfway between the pieces before and after, however long they are: at a sharp edge it looks
/// away from both. Straight away from the middle where neither has an area.
/// @param normals  3 (sides + 1)
void write_normals(const Ring& ring, const Corners& corners, const RingNeighbours& rings, std::span<float> normals);

}  // namespace tuftwave
