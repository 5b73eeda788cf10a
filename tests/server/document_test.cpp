#include "gltf/document.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "character/glb.hpp"

namespace tuftwave::server::gltf {
namespace {

using Json = nlohmann::json;

/// A document whose buffer has so many floats, which count up.
std::string file_of(std::size_t floats, Container container) {
    Document document("me");
    document.set_asset_extras(R"({"x":"\"buffers\":[{}]"})");
    const int view = document.add_view(Document::Purpose::kData, floats * 4);
    const int values =
        document.add_accessor({view, 0, floats, Document::Component::kF32, Document::Shape::kScalar, true});
    const int node = document.add_node({"n", {}, {}, {}, {}});
    document.add_to_scene(node);
    document.add_animation("wave", values, Document::Interpolation::kStep, {{node, values}}, Json{{"frames", 3}});
    document.allocate(container);
    for (std::size_t i = 0; i < floats; ++i) document.data<float>(values)[i] = static_cast<float>(i);
    document.set_bounds(values);
    return std::string(document.write(container).bytes());
}

TEST(Document, WritesBufferAndTextIntoOneFile) {
    for (const std::size_t floats : {1u, 2u, 3u, 1'000u, 100'000u}) {
        const std::string file = file_of(floats, Container::kGlb);
        const auto glb = character::split_glb(file);
        ASSERT_TRUE(std::holds_alternative<character::Glb>(glb)) << floats;
        const auto& [json, binary, others] = std::get<character::Glb>(glb);
        const Json read = Json::parse(json);
        EXPECT_EQ(read["buffers"], Json::parse("[{\"byteLength\":" + std::to_string(4 * floats) + "}]"));
        EXPECT_EQ(read["accessors"][0]["max"], Json::array({static_cast<double>(floats - 1)}));
        EXPECT_EQ(read["animations"][0]["extras"]["frames"], 3);
        ASSERT_EQ(binary.size(), 4 * floats);
        const auto* const values = reinterpret_cast<const float*>(binary.data());
        for (std::size_t i = 0; i < floats; ++i) ASSERT_EQ(values[i], static_cast<float>(i));
    }
}

TEST(Document, EncodesTheBufferWhereItStands) {
    const Json one = Json::parse(file_of(1, Container::kGltf)), two = Json::parse(file_of(2, Container::kGltf));
    const Json three = Json::parse(file_of(3, Container::kGltf));
    const std::string head = "data:application/octet-stream;base64,";
    EXPECT_EQ(one["buffers"][0]["uri"], head + "AAAAAA==");
    EXPECT_EQ(two["buffers"][0]["uri"], head + "AAAAAAAAgD8=");
    EXPECT_EQ(three["buffers"][0]["uri"], head + "AAAAAAAAgD8AAABA");
    EXPECT_EQ(file_of(3, Container::kGltf).back(), '\n');
}

}  // namespace
}  // namespace tuftwave::server::gltf
