#include "gltf/packed_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "gltf/meshopt.hpp"
#include "tuftwave/tuft.hpp"

namespace tuftwave::server::gltf {
namespace {

/// Ten tubes one after the other, since the first is not like the others.
std::vector<std::uint32_t> tubes(int sides, bool is_ordered) {
    MeshPlan plan;
    plan.ring_count = 24;
    plan.sides = sides;
    std::vector<std::uint32_t> all(10 * plan.index_count());
    for (std::size_t i = 0; i < 10; ++i) {
        const auto part = std::span(all).subspan(i * plan.index_count(), plan.index_count());
        write_indices(plan, part, static_cast<std::uint32_t>(i * plan.vertex_count()));
        if (is_ordered) order_for_packing(part, sides);
    }
    return all;
}

std::size_t packed_bytes(const std::vector<std::uint32_t>& triangles) {
    std::string room(most_for_triangles(triangles.size(), triangles.size()), '?');
    return encode_triangles(triangles, room);
}

TEST(PackedOrder, ChangesNothingButTheOrder) {
    for (const int sides : {3, 9, 10, 12, 64}) {
        const auto sorted = [](const std::vector<std::uint32_t>& triangles) {
            std::vector<std::array<std::uint32_t, 3>> all;
            for (std::size_t i = 0; i < triangles.size(); i += 3)
                all.push_back({triangles[i], triangles[i + 1], triangles[i + 2]});
            std::ranges::sort(all);
            return all;
        };
        EXPECT_EQ(sorted(tubes(sides, true)), sorted(tubes(sides, false))) << sides;
    }
}

TEST(PackedOrder, TakesAboutAByteForATriangleAndNeverMoreThanTheOtherOrder) {
    for (int sides = 3; sides <= 64; ++sides) {
        const std::vector<std::uint32_t> ordered = tubes(sides, true);
        EXPECT_LE(packed_bytes(ordered), packed_bytes(tubes(sides, false))) << sides;
        if (sides < 12) continue;
        EXPECT_LT(3.0 * static_cast<double>(packed_bytes(ordered)), 1.15 * static_cast<double>(ordered.size()))
            << sides;
    }
}

}  // namespace
}  // namespace tuftwave::server::gltf
