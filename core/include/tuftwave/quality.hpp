#pragma once

#include "tuftwave/motion.hpp"
#include "tuftwave/skeleton.hpp"
#include "tuftwave/wave.hpp"

namespace tuftwave {

/// How often the tip's path over one cycle crosses itself, for a straight hair of `bones` equal bones: 1 is the
/// animators' figure of eight, 0 a path that swings to and fro.
int tip_crossings(const Wave& wave, int bones);

/// The largest turn of any bone between neighbouring pictures, radians, from the last picture to the first included.
double largest_step(const Chain& chain, const ChainMotion& motion);

}  // namespace tuftwave
