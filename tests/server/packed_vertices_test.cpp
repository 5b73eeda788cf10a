#include "gltf/packed_vertices.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

namespace tuftwave::server::gltf {
namespace {

constexpr double kHalfStep = 0.51;  // half a step, and what float32 adds to it

TEST(PackedVertices, PositionsAreOffByHalfAStepOfTheLongestEdge) {
    std::vector<float> points;
    for (int i = 0; i < 1'000; ++i) {
        const auto t = static_cast<float>(i);
        points.insert(points.end(), {-0.3F + 0.0007F * t, 0.2F * std::sin(t), 1.6F + 0.05F * std::cos(3 * t)});
    }
    const Grid grid = grid_of(bounds_of(points));
    EXPECT_FLOAT_EQ(grid.edge, 0.0007F * 999);
    std::vector<std::uint16_t> packed(points.size() / 3 * 4);
    pack_positions(points, grid, packed);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double step = static_cast<double>(grid.edge) / 65'535;
        const double back = static_cast<double>(grid.origin[i % 3]) + step * packed[i / 3 * 4 + i % 3];
        ASSERT_NEAR(back, static_cast<double>(points[i]), kHalfStep * step + 1e-7) << i;
        EXPECT_EQ(packed[i / 3 * 4 + 3], 0);
    }
    EXPECT_EQ(packed[0], 0);
    EXPECT_EQ(packed[999 * 4], 65'535);
}

TEST(PackedVertices, APointHasAGridToo) {
    const std::array<float, 3> point{1, -2, 3};
    const Grid grid = grid_of(bounds_of(point));
    EXPECT_GT(grid.edge, 0);
    std::array<std::uint16_t, 4> packed{1, 1, 1, 1};
    pack_positions(point, grid, packed);
    EXPECT_EQ(packed, (std::array<std::uint16_t, 4>{}));
}

TEST(PackedVertices, NormalsAreWhole127ths) {
    const std::array<float, 12> normals{1, 0, 0, 0, -1, 0, 0.6F, -0.8F, 0, 0, 0.004F, -0.99999F};
    std::array<std::int8_t, 16> packed{};
    pack_normals(normals, packed);
    EXPECT_EQ(packed, (std::array<std::int8_t, 16>{127, 0, 0, 0, 0, -127, 0, 0, 76, -102, 0, 0, 0, 1, -127, 0}));
}

TEST(PackedVertices, UvsAreWhole65535ths) {
    const std::array<float, 4> uvs{0, 1, 0.5F, 1.0F / 3};
    std::array<std::uint16_t, 4> packed{};
    pack_uvs(uvs, packed);
    EXPECT_EQ(packed, (std::array<std::uint16_t, 4>{0, 65'535, 32'768, 21'845}));
}

TEST(PackedVertices, AreTheSameWithAllVectors) {
    for (const std::size_t count : {1u, 3u, 4u, 7u, 1'001u}) {
        std::vector<float> numbers;
        for (std::size_t i = 0; i < 3 * count; ++i) numbers.push_back(std::sin(static_cast<float>(i * i)));
        const Grid grid = grid_of(bounds_of(numbers));
        const auto packed = [&](Vectors vectors) {
            std::vector<std::uint16_t> positions(4 * count, 1), uvs(3 * count, 1);
            std::vector<std::int8_t> normals(4 * count, 1);
            pack_positions(numbers, grid, positions, vectors);
            pack_normals(numbers, normals, vectors);
            pack_uvs(numbers, uvs, vectors);
            return std::tuple{positions, normals, uvs};
        };
        for (const Vectors vectors : usable_vectors()) EXPECT_EQ(packed(vectors), packed(Vectors::kNarrow)) << count;
    }
}

TEST(PackedVertices, WeightsAddUpToAWhole) {
    std::vector<float> weights{1, 0, 0, 0, 0.5F, 0.5F, 0, 0, 0.25F, 0.25F, 0.25F, 0.25F, 0.334F, 0.333F, 0.333F, 0};
    for (int i = 0; i <= 1'000; ++i) {
        const float first = static_cast<float>(i) / 1'000;
        weights.insert(weights.end(), {first, 1 - first, 0, 0});
    }
    std::vector<std::uint8_t> packed(weights.size());
    pack_weights(weights, packed);
    for (std::size_t i = 0; i < packed.size(); i += 4) {
        EXPECT_EQ(std::accumulate(&packed[i], &packed[i] + 4, 0), 255) << i;
        for (std::size_t k = i; k < i + 4; ++k) EXPECT_NEAR(packed[k], 255 * weights[k], 1.01) << k;
    }
}

TEST(PackedVertices, JointsStayTheSame) {
    const std::array<std::uint16_t, 4> joints{0, 1, 254, 255};
    std::array<std::uint8_t, 4> packed{};
    pack_joints(joints, packed);
    EXPECT_EQ(packed, (std::array<std::uint8_t, 4>{0, 1, 254, 255}));
}

}  // namespace
}  // namespace tuftwave::server::gltf
