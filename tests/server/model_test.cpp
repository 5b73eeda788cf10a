#include "gltf/model.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tuftwave::server::gltf {
namespace {

std::string text_of(const Document::Model& model) {
    JsonText counted;
    write_json(model, counted, {});
    std::string text(counted.bytes(), '?');
    JsonText written(text.data());
    write_json(model, written, {});
    return text;
}

TEST(Model, WritesKeysInAlphabeticalOrderAndLeavesOutWhatIsNotSaid) {
    Document::Model model;
    model.generator = "me";
    model.bytes = 8;
    model.views = {{Document::Purpose::kAttribute, 0, 4, 4}, {Document::Purpose::kData, 4, 4, 0}};
    model.accessors = {{0, 0, 1}, {1, 4, 1, Document::Component::kU16, Document::Shape::kVec4}};
    model.bounds = {{0, {{0.5F}, {1.5F}}}};
    model.materials = {{"white", {1, 1, 1}}, {"red", {1, 0, 0}}};
    model.meshes = {{"m", {0, 1, 2, 3, {}, 5, 6}}};
    model.nodes = {{{}, model.add_members({"n", std::array{0.0, 1.0, 2.0}, {}, 0, 0, 2.0}), model.add_text("{}")},
                   {0, model.add_members({"", {}, {}, {}, {}})}};
    model.roots = {0};
    model.skins = {{{0, 1}, 4, 0}};
    EXPECT_EQ(
        text_of(model),
        R"({"accessors":[{"bufferView":0,"componentType":5126,"count":1,"max":[1.5],"min":[0.5],"type":"SCALAR"},)"
        R"({"bufferView":1,"byteOffset":4,"componentType":5123,"count":1,"type":"VEC4"}],)"
        R"("asset":{"generator":"me","version":"2.0"},)"
        R"("bufferViews":[{"buffer":0,"byteLength":4,"byteStride":4,"target":34962},)"
        R"({"buffer":0,"byteLength":4,"byteOffset":4}],"buffers":[{"byteLength":8}],)"
        R"("materials":[{"name":"white","pbrMetallicRoughness":{"metallicFactor":0.0,"roughnessFactor":0.9}},)"
        R"({"name":"red","pbrMetallicRoughness":{"baseColorFactor":[1.0,0.0,0.0,1.0],"metallicFactor":0.0,)"
        R"("roughnessFactor":0.9}}],"meshes":[{"name":"m","primitives":[{"attributes":{"JOINTS_0":3,"NORMAL":1,)"
        R"("POSITION":0,"TEXCOORD_0":2},"indices":5,"material":6,"mode":4}]}],)"
        R"("nodes":[{"children":[1],"extras":{},"mesh":0,"name":"n","scale":[2.0,2.0,2.0],"skin":0,)"
        R"("translation":[0.0,1.0,2.0]},{}],"scene":0,"scenes":[{"nodes":[0]}],)"
        R"("skins":[{"inverseBindMatrices":4,"joints":[0,1],"skeleton":0}]})");
}

/// One of everything, and one more of each in turn, as long as it can be.
TEST(Model, KnowsHowLongItsTextIsAtMost) {
    constexpr int kLongest = std::numeric_limits<int>::min();
    constexpr std::size_t kLargest = std::numeric_limits<std::size_t>::max();
    constexpr double kDigits = -1.2345678901234567e-308;
    constexpr int kRoot = 0;
    const std::string name(100, '\x01');
    Document::Model model;
    const auto is_within = [&] { return text_of(model).size() <= most_json_bytes(model); };
    model.generator = name;
    model.extras = R"({"a":1})";
    model.bytes = kLargest;
    model.nodes.push_back({{}, model.add_members({"root", {}, {}, {}, {}})});
    EXPECT_TRUE(is_within());
    for (int i = 0; i < 50; ++i) {
        model.views.push_back({Document::Purpose::kAttribute, kLargest, kLargest, kLargest});
        EXPECT_TRUE(is_within()) << "views";
        model.accessors.push_back({kLongest, kLargest, kLargest, Document::Component::kF32, Document::Shape::kVec3});
        EXPECT_TRUE(is_within()) << "accessors";
        model.accessors.back().is_bounded = true;
        constexpr auto kFewer = static_cast<float>(-1.2345678901234567e-30);  // as many digits, but for the exponent
        model.bounds.push_back({i, {{kFewer, kFewer, kFewer}, {kFewer, kFewer, kFewer}}});
        EXPECT_TRUE(is_within()) << "bounds";
        model.materials.push_back({name, {kDigits, kDigits, kDigits}});
        EXPECT_TRUE(is_within()) << "materials";
        model.meshes.push_back({name, {kLongest, kLongest, kLongest, kLongest, kLongest, kLongest, kLongest}});
        EXPECT_TRUE(is_within()) << "meshes";
        const Document::Node node{name,
                                  std::array{kDigits, kDigits, kDigits},
                                  std::array{kDigits, kDigits, kDigits, kDigits},
                                  kLongest,
                                  kLongest,
                                  kDigits};
        model.nodes.push_back({kRoot, model.add_members(node), model.add_text(R"({"b":2})")});
        EXPECT_TRUE(is_within()) << "nodes";
        model.roots.push_back(kLongest);
        EXPECT_TRUE(is_within()) << "roots";
        model.skins.push_back({{kLongest}, kLongest, kLongest});
        EXPECT_TRUE(is_within()) << "skins";
        model.animations.push_back({name, kLongest, Document::Interpolation::kLinear, {{kLongest, kLongest}}, "{}"});
        EXPECT_TRUE(is_within()) << "animations";
    }
}

TEST(Model, SaysHowAViewIsPackedAndWhatAReaderMustKnow) {
    Document::Model model;
    model.generator = "me";
    model.bytes = 28;
    model.fallback = 48;
    model.extensions = {"A_b", "C_d"};
    model.views = {{Document::Purpose::kAttribute, 0, 24, 8,
                    Document::Model::Packed{0, 15, 8, 3, Document::Model::Packed::Mode::kAttributes}},
                   {Document::Purpose::kIndex, 24, 24, 0,
                    Document::Model::Packed{16, 9, 4, 6, Document::Model::Packed::Mode::kTriangles}}};
    model.accessors = {{0, 0, 3, Document::Component::kI8, Document::Shape::kVec3, false, true}};
    EXPECT_EQ(
        text_of(model),
        R"({"accessors":[{"bufferView":0,"componentType":5120,"count":3,"normalized":true,"type":"VEC3"}],)"
        R"("asset":{"generator":"me","version":"2.0"},"bufferViews":[{"buffer":1,"byteLength":24,"byteStride":8,)"
        R"("extensions":{"EXT_meshopt_compression":{"buffer":0,"byteLength":15,"byteOffset":0,"byteStride":8,"count":3,)"
        R"("mode":"ATTRIBUTES"}},"target":34962},{"buffer":1,"byteLength":24,"byteOffset":24,)"
        R"("extensions":{"EXT_meshopt_compression":{"buffer":0,"byteLength":9,"byteOffset":16,"byteStride":4,"count":6,)"
        R"("mode":"TRIANGLES"}},"target":34963}],"buffers":[{"byteLength":28},)"
        R"({"byteLength":48,"extensions":{"EXT_meshopt_compression":{"fallback":true}}}],)"
        R"("extensionsRequired":["A_b","C_d"],"extensionsUsed":["A_b","C_d"],"scene":0,"scenes":[{}]})");
}

}  // namespace
}  // namespace tuftwave::server::gltf
