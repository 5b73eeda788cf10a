#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tuftwave/curve.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/result.hpp"

namespace tuftwave {

/// A skeleton without branches: n segments between n + 1 nodes, root first. Node i turns segment i; the last node is
/// the tip and turns nothing.
struct Chain {
    std::string name;
    std::vector<Vec3> nodes;           ///< rest positions in model space, metres
    std::vector<Quat> rest_rotations;  ///< local, one per node, as glTF's node.rotation
    Quat parent_rotation;              ///< model-space rest rotation of what the root hangs on
    double phase = 0;                  ///< radians, added to the wave's phase
    std::optional<int> cycles;         ///< waves per loop; motion.phase.cycles when empty
    std::optional<Vec3> outward;       ///< unit, away from the head at the root; what one_sided needs
    std::string block = "hair";        ///< of a sheet; travels along and changes no motion
};

/// @errors  too_few, too_many (nodes), not_finite, out_of_range, conflict (not one rest rotation per node), degenerate
///          (a chain or quaternion without length)
Check check_chain(const Chain& chain, const Limits& limits);

/// @errors  those of check_chain; too_few, too_many (chains, or bones in all)
Check check_chains(std::span<const Chain> chains, const Limits& limits);

/// A chain of `joints` bones of equal arc length along a curve. Each bone's local +Y runs along it, its +Z along the
/// curve's normal, so that a chain looks like a chain in tools that draw bones along +Y.
/// @param joints  >= 1
Chain chain_along(const Curve& curve, int joints);

/// Which two bones move a point of a tuft, and how much the second one does.
struct Influence {
    std::uint16_t first, second;  ///< neighbouring bones, root first; equal where one bone alone holds the point
    double second_weight;         ///< 0..1; the first bone has the rest
};

/// Weights that blend smoothly from the middle of one bone to the middle of the next.
/// @param along  share of the arc length, 0 to 1
Influence influence_at(double along, int joints);

}  // namespace tuftwave
