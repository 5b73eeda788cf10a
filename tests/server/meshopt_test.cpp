#include "gltf/meshopt.hpp"

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <string>
#include <vector>

#include "gltf/packed_order.hpp"
#include "tuftwave/tuft.hpp"

namespace tuftwave::server::gltf {
namespace {

const unsigned char* raw(const std::string& bytes) { return reinterpret_cast<const unsigned char*>(bytes.data()); }

TEST(Meshopt, ElementsComeBackAsTheyWere) {
    for (const std::size_t stride : {4u, 8u, 16u, 64u}) {
        for (const std::size_t count : {1u, 15u, 16u, 17u, 1'000u}) {
            std::vector<std::byte> elements(stride * count), back(stride * count);
            for (std::size_t i = 0; i < elements.size(); ++i) elements[i] = static_cast<std::byte>(i * i >> 3 & 255);
            std::string packed(most_for_attributes(count, stride), '?');
            packed.resize(encode_attributes(elements, stride, packed));
            ASSERT_EQ(meshopt_decodeVertexBuffer(back.data(), count, stride, raw(packed), packed.size()), 0);
            EXPECT_EQ(back, elements) << stride << " x " << count;
            EXPECT_EQ(raw(packed)[0], 0xA0) << "the only format that the extension knows";
        }
    }
}

TEST(Meshopt, TrianglesComeBackInOrderAndWayRound) {
    const std::vector<std::uint32_t> triangles{0, 1, 2, 2, 1, 3, 70'000, 2, 3, 3, 70'001, 70'000};
    std::string packed(most_for_triangles(triangles.size(), 70'002), '?');
    packed.resize(encode_triangles(triangles, packed));
    EXPECT_EQ(raw(packed)[0], 0xE1) << "the only format that the extension knows";
    std::vector<std::uint32_t> back(triangles.size());
    ASSERT_EQ(meshopt_decodeIndexBuffer(back.data(), back.size(), 4, raw(packed), packed.size()), 0);
    for (std::size_t i = 0; i < triangles.size(); i += 3) {  // each may begin at another corner
        std::size_t turn = 0;
        while (turn < 3 && back[i + turn] != triangles[i]) ++turn;
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(back[i + (turn + k) % 3], triangles[i + k]) << i;
    }
}

/// Triangles of tubes, one after the other, each with vertices of its own.
std::vector<std::uint32_t> tubes(std::size_t count, int rings, int sides) {
    std::vector<std::uint32_t> all;
    MeshPlan plan;
    plan.ring_count = static_cast<std::size_t>(rings);
    plan.sides = sides;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t first = all.size();
        all.resize(first + plan.index_count());
        const auto part = std::span(all).subspan(first);
        write_indices(plan, part, static_cast<std::uint32_t>(i * plan.vertex_count()));
        order_for_packing(part, sides);
    }
    return all;
}

std::string by_library(const std::vector<std::uint32_t>& triangles) {
    std::string bytes(most_for_triangles(triangles.size(), triangles.size()), '?');
    auto* const to = reinterpret_cast<unsigned char*>(bytes.data());
    bytes.resize(meshopt_encodeIndexBuffer(to, bytes.size(), triangles.data(), triangles.size()));
    return bytes;
}

std::string by_us(const std::vector<std::uint32_t>& triangles) {
    std::string bytes(most_for_triangles(triangles.size(), triangles.size()), '?');
    bytes.resize(encode_triangles(triangles, bytes));
    return bytes;
}

TEST(Meshopt, PartsThatComeAgainAreWrittenAsTheLibraryWritesThem) {
    for (const int rings : {2, 3, 7, 64}) {
        for (const int sides : {3, 4, 12, 63}) {
            for (const std::size_t count : {1u, 2u, 3u, 4u, 5u, 9u, 300u}) {
                const std::vector<std::uint32_t> triangles = tubes(count, rings, sides);
                ASSERT_EQ(by_us(triangles), by_library(triangles)) << count << " of " << rings << " x " << sides;
            }
        }
    }
}

TEST(Meshopt, PartsThatOnlyAlmostComeAgainAreWrittenAsTheLibraryWritesThem) {
    const std::vector<std::uint32_t> same = tubes(8, 5, 6);
    for (const std::size_t changed : {std::size_t{0}, same.size() / 2, same.size() - 1}) {
        std::vector<std::uint32_t> triangles = same;
        triangles[changed] += 1;
        EXPECT_EQ(by_us(triangles), by_library(triangles)) << changed;
    }
    std::vector<std::uint32_t> longer = same;
    longer.insert(longer.end(), same.begin(), same.begin() + 3);
    EXPECT_EQ(by_us(longer), by_library(longer));
    std::vector<std::uint32_t> turned;  // vertices of a part come in no order
    for (const std::uint32_t index : same) turned.push_back(index / 32 * 32 + (31 - index % 32));
    EXPECT_EQ(by_us(turned), by_library(turned));
}

}  // namespace
}  // namespace tuftwave::server::gltf
