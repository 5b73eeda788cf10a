#pragma once

#include <span>
#include <vector>

#include "tuftwave/motion.hpp"
#include "tuftwave/wide.hpp"

namespace tuftwave {

/// What is taken out of the angles that a bone has in all pictures: nothing, the least of them, or their mean.
enum class Shift { kNone, kLeast, kMean };

/// Swings one chain through its pictures.
/// @param phases  psi of each picture, radians
/// @return  picture n, node i at [n * nodes + i]: local, unit, sign-continuous
/// Cost O(pictures * nodes). The same bits for any `vectors`, and for the same phases in another order.
std::vector<Quat> swing(const Chain& chain, const Motion& motion, std::span<const double> phases, Shift shift,
                        Vectors vectors);

}  // namespace tuftwave
