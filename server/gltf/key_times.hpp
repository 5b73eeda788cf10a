#pragma once

#include <vector>

#include "tuftwave/schedule.hpp"

namespace tuftwave::server::gltf {

/// The times of a held clip's keys, seconds: one per picture, and one that closes the loop at the end of the last hold.
/// Each but the first is the largest float32 strictly below its frame's time, so that a player that asks for exactly
/// frame / fps is past it. Measured with three.js and Babylon.js: any other rounding shows wrong pictures.
std::vector<float> key_times(const Schedule& schedule);

}  // namespace tuftwave::server::gltf
