#pragma once

#include "tuftwave/curve.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/result.hpp"
#include "tuftwave/tuft.hpp"

namespace tuftwave {

/// The rings of a tuft along its curve, root to tip, apexes left out; a flat tip's last ring is at the very end.
/// @errors  too_many
Result<Rings> choose_rings(const Curve& curve, const Tuft& tuft, double diameter, const MeshDetail& detail,
                           const Limits& limits, Vectors vectors);

}  // namespace tuftwave
