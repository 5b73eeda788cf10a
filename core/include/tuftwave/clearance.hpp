#pragma once

#include <span>
#include <vector>

#include "tuftwave/math.hpp"
#include "tuftwave/scalp.hpp"

namespace tuftwave {

/// Where along a tuft its centre line is outside of the scalp: one answer for each of kClearanceShares + 1 places,
/// evenly along the arc length from the sunk root to the tip.
using Clearance = std::vector<bool>;

inline constexpr int kClearanceShares = 96;

/// @param stroke      in the head's frame, metres, root first
/// @param root_depth  how far the root is sunk, metres
Clearance clearance_of(std::span<const Vec3> stroke, const Scalp& scalp, double root_depth);

/// Where both are outside.
Clearance common_clearance(const Clearance& a, const Clearance& b);

/// What bend_outwards had to do.
enum class Bend { kNone, kBent, kStuck };

/// Bends a stroke outwards until it is outside of the scalp wherever `wanted` says so: the point nearest to the deepest
/// place moves out by the shortest way, and the rest of the stroke moves along. The root stays.
/// @param stroke  in the head's frame, metres, root first and on the scalp; at least 2 points
/// @return  kStuck where it runs through the head in a way that bending does not mend
/// Cost O(points log triangles) for each place that is bent.
Bend bend_outwards(std::vector<Vec3>& stroke, const Clearance& wanted, const Scalp& scalp, double root_depth);

}  // namespace tuftwave
