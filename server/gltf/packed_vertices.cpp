#include "gltf/packed_vertices.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace tuftwave::server::gltf {
namespace {

constexpr float kMost16 = 65'535, kMost8 = 127, kWhole = 255;

/// The nearest whole number. @param value  0..65,535
std::int32_t nearest(float value) { return static_cast<std::int32_t>(value + 0.5F); }

std::uint16_t to_16(float share) {
    return static_cast<std::uint16_t>(nearest(std::clamp(share, 0.0F, 1.0F) * kMost16));
}

/// Counted from -128, so that what is cut off is always cut off downwards.
std::int8_t to_8(float value) { return static_cast<std::int8_t>(nearest(value * kMost8 + 128) - 128); }

}  // namespace

Grid grid_of(const Bounds& bounds) {
    Grid grid{bounds.least, 0};
    for (std::size_t axis = 0; axis < 3; ++axis)
        grid.edge = std::max(grid.edge, bounds.most[axis] - bounds.least[axis]);
    grid.edge = std::max(grid.edge, std::numeric_limits<float>::min());
    return grid;
}

void pack_positions(std::span<const float> from, const Grid& grid, std::span<std::uint16_t> to) {
    const auto [x, y, z] = grid.origin;
    const float share = 1 / grid.edge;
    for (std::size_t i = 0; i < from.size() / 3; ++i) {
        to[4 * i] = to_16((from[3 * i] - x) * share);
        to[4 * i + 1] = to_16((from[3 * i + 1] - y) * share);
        to[4 * i + 2] = to_16((from[3 * i + 2] - z) * share);
        to[4 * i + 3] = 0;
    }
}

void pack_normals(std::span<const float> from, std::span<std::int8_t> to) {
    for (std::size_t i = 0; i < from.size() / 3; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) to[4 * i + axis] = to_8(from[3 * i + axis]);
        to[4 * i + 3] = 0;
    }
}

void pack_uvs(std::span<const float> from, std::span<std::uint16_t> to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = to_16(from[i]);
}

void pack_weights(std::span<const float> from, std::span<std::uint8_t> to) {
    for (std::size_t i = 0; i < from.size(); i += 4) {
        std::array<std::int32_t, 4> whole{};
        std::int32_t sum = 0;
        for (std::size_t k = 0; k < 4; ++k) sum += whole[k] = nearest(from[i + k] * kWhole);
        *std::ranges::max_element(whole) += 255 - sum;  // where it shows least
        for (std::size_t k = 0; k < 4; ++k) to[i + k] = static_cast<std::uint8_t>(whole[k]);
    }
}

void pack_joints(std::span<const std::uint16_t> from, std::span<std::uint8_t> to) {
    std::ranges::transform(from, to.begin(), [](std::uint16_t joint) { return static_cast<std::uint8_t>(joint); });
}

}  // namespace tuftwave::server::gltf
