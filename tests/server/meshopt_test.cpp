#include "gltf/meshopt.hpp"

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <string>
#include <vector>

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

}  // namespace
}  // namespace tuftwave::server::gltf
