#include "gltf/packed_vertices.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace tuftwave::server::gltf {
namespace {

constexpr float kMost16 = 65'535, kMost8 = 127, kWhole = 255;
constexpr std::size_t kSide = 4;  // vertices that are packed side by side

/// The nearest whole number. @param value  not negative
TUFTWAVE_BODY std::int32_t nearest(float value) { return static_cast<std::int32_t>(value + 0.5F); }

TUFTWAVE_BODY std::int32_t to_16(float share) {
    const float most = share < 1 ? share : 1.0F;
    return nearest((most > 0 ? most : 0.0F) * kMost16);
}

/// Counted from -128, so that what is cut off is always cut off downwards.
TUFTWAVE_BODY std::int32_t to_8(float value) { return nearest(value * kMost8 + 128) - 128; }

/// Packs three numbers of each vertex by themselves, side by side as long as there are enough vertices.
/// @param pack  a number and its axis to a whole number
template <class To, class Pack>
TUFTWAVE_BODY void pack_threes(std::span<const float> from, std::span<To> to, const Pack& pack) {
    const std::size_t count = from.size() / 3;
    std::size_t i = 0;
    for (; i + kSide <= count; i += kSide) {
        const float* const three = from.data() + 3 * i;
        To* const four = to.data() + 4 * i;
        std::array<std::int32_t, 3 * kSide> whole;
        for (std::size_t k = 0; k < 3 * kSide; ++k) whole[k] = pack(three[k], k);
        for (std::size_t v = 0; v < kSide; ++v) {
            for (std::size_t axis = 0; axis < 3; ++axis) four[4 * v + axis] = static_cast<To>(whole[3 * v + axis]);
            four[4 * v + 3] = 0;
        }
    }
    for (; i < count; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) to[4 * i + axis] = static_cast<To>(pack(from[3 * i + axis], axis));
        to[4 * i + 3] = 0;
    }
}

TUFTWAVE_BODY void positions(std::span<const float> from, const Grid& grid, std::span<std::uint16_t> to) {
    std::array<float, 3 * kSide> origin;
    for (std::size_t k = 0; k < origin.size(); ++k) origin[k] = grid.origin[k % 3];
    const float share = 1 / grid.edge;
    pack_threes(from, to, [&](float value, std::size_t k) { return to_16((value - origin[k]) * share); });
}

TUFTWAVE_BODY void normals(std::span<const float> from, std::span<std::int8_t> to) {
    pack_threes(from, to, [](float value, std::size_t) { return to_8(value); });
}

TUFTWAVE_BODY void uvs(std::span<const float> from, std::span<std::uint16_t> to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = static_cast<std::uint16_t>(to_16(from[i]));
}

}  // namespace

Grid grid_of(const Bounds& bounds) {
    Grid grid{bounds.least, 0};
    for (std::size_t axis = 0; axis < 3; ++axis)
        grid.edge = std::max(grid.edge, bounds.most[axis] - bounds.least[axis]);
    grid.edge = std::max(grid.edge, std::numeric_limits<float>::min());
    return grid;
}

void pack_positions(std::span<const float> from, const Grid& grid, std::span<std::uint16_t> to, Vectors vectors) {
    run_with<positions>(vectors, from, grid, to);
}

void pack_normals(std::span<const float> from, std::span<std::int8_t> to, Vectors vectors) {
    run_with<normals>(vectors, from, to);
}

void pack_uvs(std::span<const float> from, std::span<std::uint16_t> to, Vectors vectors) {
    run_with<uvs>(vectors, from, to);
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
