#pragma once

#include <span>
#include <vector>

#include "tuftwave/tuft.hpp"

namespace tuftwave {

/// How far each corner of each ring may stand off the centre line so that the surface does not fold over itself where
/// the tuft bends more tightly than it is thick.
/// @return  rings x sides shares in [0, 1] of the corner's full distance; empty when all are 1
/// Cost O(rings * sides).
std::vector<float> unfolding_reach(std::span<const Ring> rings, int sides, Vectors vectors);

}  // namespace tuftwave
