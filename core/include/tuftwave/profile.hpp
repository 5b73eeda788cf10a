#pragma once

#include <span>

#include "tuftwave/wide.hpp"

namespace tuftwave {

/// How the diameter grows from the root to the widest place and shrinks to the tip.
enum class Taper { kSine, kLinear, kSmooth, kRound };

/// The share of the full diameter at a distance along a tuft.
/// @param along      share of the arc length from the root, 0 to 1
/// @param widest_at  p as a share of the arc length, above 0, at most 1
/// @return  0 at the root, 1 at the widest place, 0 at the tip (1 where widest_at is 1)
/// Source: Shimosoyama, Yamamoto and Noma, section 3.2.
double profile_width(Taper taper, double along, double widest_at);

/// The same for many places at once. @param out  as many as `along`
void profile_widths(Taper taper, std::span<const double> along, double widest_at, std::span<double> out,
                    Vectors vectors = widest_vectors());

}  // namespace tuftwave
