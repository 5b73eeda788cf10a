#pragma once

#include "tuftwave/tuft.hpp"

namespace tuftwave {

/// What has to be cut off where the tuft bends more tightly than it is thick.
/// Cost O(rings + cut rings * sides).
Reach unfolding_reach(const Rings& rings, int sides, Vectors vectors);

}  // namespace tuftwave
