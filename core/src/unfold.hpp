#pragma once

#include <span>

#include "tuftwave/tuft.hpp"

namespace tuftwave {

/// What has to be cut off where the tuft bends more tightly than it is thick.
/// Cost O(rings + cut rings * sides).
Reach unfolding_reach(std::span<const Ring> rings, int sides, Vectors vectors);

}  // namespace tuftwave
