#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tuftwave/tuft.hpp"
#include "tuftwave/wide.hpp"

namespace tuftwave {

/// Where the rings of a tuft go, sides + 1 vertices each.
struct SurfaceSpans {
    std::span<float> positions, normals, uvs;  ///< 3, 3 and 2 per vertex
};

/// Writes all rings: the corners; the normals as write_normals() does, but in floats, from where corners stand relative
/// to their ring; u and v.
/// @return  the rings whose normals are left to write_normals(), since floats are not good enough for one of their
/// normals: they
///          are much thinner than others of the tuft, or nearly meet, or have a sharp edge
std::vector<std::size_t> write_surface_quickly(const MeshPlan& plan, Vectors vectors, const SurfaceSpans& out);

}  // namespace tuftwave
