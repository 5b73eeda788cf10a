#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "gltf/bounds.hpp"
#include "tuftwave/wide.hpp"

/// A mesh's numbers as few bits, as KHR_mesh_quantization allows: half of the bytes that floats take.
/// `vectors` change nothing but the time.
namespace tuftwave::server::gltf {

/// The cube in which positions are counted in 65,535ths of its edge. The same edge along all axes, since normals would
/// be bent by anything else.
struct Grid {
    std::array<float, 3> origin;  ///< the least corner, metres
    float edge;                   ///< metres, more than 0
};

Grid grid_of(const Bounds& bounds);

/// @param from  three floats per vertex, within the grid
/// @param to    four numbers per vertex, the last of which is 0; they stand for 0..1 of the grid's edge
/// They are off by half a 65,535th of the edge at most, but for the rounding of float32.
void pack_positions(std::span<const float> from, const Grid& grid, std::span<std::uint16_t> to,
                    Vectors vectors = widest_vectors());

/// @param from  three floats per vertex, of length 1
/// @param to    four numbers per vertex, the last of which is 0; they stand for -1..1
void pack_normals(std::span<const float> from, std::span<std::int8_t> to, Vectors vectors = widest_vectors());

/// @param from  two floats per vertex, 0..1
/// @param to    two numbers per vertex, which stand for 0..1
void pack_uvs(std::span<const float> from, std::span<std::uint16_t> to, Vectors vectors = widest_vectors());

/// @param from  four floats per vertex, whose sum is 1
/// @param to    four numbers per vertex, whose sum is 255
void pack_weights(std::span<const float> from, std::span<std::uint8_t> to);

/// @param from  numbers below 256
void pack_joints(std::span<const std::uint16_t> from, std::span<std::uint8_t> to);

}  // namespace tuftwave::server::gltf
