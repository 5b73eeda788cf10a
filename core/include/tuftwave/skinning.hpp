#pragma once

#include <span>

#include "tuftwave/math.hpp"
#include "tuftwave/skeleton.hpp"
#include "tuftwave/tuft.hpp"

namespace tuftwave {

/// Moves a mesh with its bones by linear blend skinning, as a graphics card does it: for tools that cannot.
/// @param rest       as to_mesh() makes it; its joints are the chain's
/// @param rotations  local, one per node
/// @param positions  3 per vertex, metres
/// @param normals    3 per vertex, unit
/// Cost O(vertices + nodes). Thread-safe for disjoint spans. Deterministic.
void write_posed_vertices(const Mesh& rest, const Chain& chain, std::span<const Quat> rotations,
                          std::span<float> positions, std::span<float> normals);

}  // namespace tuftwave
