#include "gltf/model.hpp"

#include <gtest/gtest.h>

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
    model.bounds = {{1, {0.5}, {1.5}}};
    model.materials = {{"white", {1, 1, 1}}, {"red", {1, 0, 0}}};
    model.meshes = {{"m", {0, 1, 2, 3, {}, 5, 6}}};
    model.nodes = {{{"n", std::array{0.0, 1.0, 2.0}, {}, 0, 0, 2.0}, {1}, "{}"}, {{"", {}, {}, {}, {}}, {}, ""}};
    model.roots = {0};
    model.skins = {{{0, 1}, 4, 0}};
    EXPECT_EQ(
        text_of(model),
        R"({"accessors":[{"bufferView":0,"componentType":5126,"count":1,"type":"SCALAR"},)"
        R"({"bufferView":1,"byteOffset":4,"componentType":5123,"count":1,"max":[1.5],"min":[0.5],"type":"VEC4"}],)"
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

}  // namespace
}  // namespace tuftwave::server::gltf
