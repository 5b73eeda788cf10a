#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tuftwave/tuft.hpp"
#include "tuftwave/wide.hpp"

namespace tuftwave {

/// Writes the corners of all rings and their normals as write_corners() does, the corners to the same bits; normals are
/// computed in floats, from where corners stand relative to their ring.
/// @param positions, normals  3 (sides + 1) per ring
/// @return  the rings that are left to write_corners(), since floats are not good enough for one of their normals: they
///          are much thinner than others of the tuft, or nearly meet, or have a sharp edge
std::vector<std::size_t> write_surface_quickly(const MeshPlan& plan, Vectors vectors, std::span<float> positions,
                                               std::span<float> normals);

}  // namespace tuftwave
