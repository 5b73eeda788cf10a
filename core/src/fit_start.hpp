#pragma once

#include <vector>

#include "drawn_plane.hpp"
#include "wave_unknowns.hpp"

namespace tuftwave {

/// Waves from which a refinement may well find the best one: the best of a grid over 1/k and p, of each direction of
/// travel, each with its linear unknowns solved for. Likeliest first.
/// Cost O(grid * bones + pictures * bones).
std::vector<WaveUnknowns> likely_waves(const DrawnPlane& plane, const WaveBounds& bounds);

}  // namespace tuftwave
