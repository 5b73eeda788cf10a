#include "gltf/packed_file.hpp"

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "character/glb.hpp"
#include "exec/pool.hpp"
#include "support.hpp"

namespace tuftwave::server::gltf {
namespace {

using Json = nlohmann::json;

/// Numbers in an element of an accessor that is no matrix.
std::size_t width_of(const Json& accessor) {
    const std::string type = accessor["type"];
    return type == "SCALAR" ? 1 : static_cast<std::size_t>(type[3] - '0');
}

/// A GLB, its packed views unpacked as a reader does it.
struct Read {
    Json json;
    std::vector<std::string> views;

    /// A number of an accessor as a reader gets it.
    double number(const Json& accessor, std::size_t element, std::size_t k) const {
        const std::size_t view = json["accessors"][accessor.get<std::size_t>()]["bufferView"];
        const Json& said = json["accessors"][accessor.get<std::size_t>()];
        const std::size_t size = said["componentType"] == 5126 || said["componentType"] == 5125 ? 4
                                 : said["componentType"] == 5123                                ? 2
                                                                                                : 1;
        const std::size_t width = width_of(said);
        const std::size_t stride = json["bufferViews"][view].value("byteStride", size * width);
        const char* const at =
            views[view].data() + said.value("byteOffset", std::size_t{0}) + stride * element + size * k;
        const double scale = said.value("normalized", false) ? 1 : 0;
        switch (said["componentType"].get<int>()) {
            case 5120:
                return *reinterpret_cast<const std::int8_t*>(at) / (scale > 0 ? 127.0 : 1);
            case 5121:
                return *reinterpret_cast<const std::uint8_t*>(at) / (scale > 0 ? 255.0 : 1);
            case 5123:
                return *reinterpret_cast<const std::uint16_t*>(at) / (scale > 0 ? 65'535.0 : 1);
            case 5125:
                return *reinterpret_cast<const std::uint32_t*>(at);
        }
        return static_cast<double>(*reinterpret_cast<const float*>(at));
    }
};

Read read(const std::string& file) {
    const auto split = character::split_glb(file);
    const auto& [text, binary, others] = std::get<character::Glb>(split);
    Read made{Json::parse(text), {}};
    for (const Json& view : made.json["bufferViews"]) {
        std::string& bytes = made.views.emplace_back(view["byteLength"].get<std::size_t>(), '\0');
        if (!view.contains("extensions")) {
            bytes = std::string(binary.substr(view.value("byteOffset", std::size_t{0}), bytes.size()));
            continue;
        }
        const Json& packed = view["extensions"]["EXT_meshopt_compression"];
        const std::size_t count = packed["count"], stride = packed["byteStride"], length = packed["byteLength"];
        EXPECT_EQ(count * stride, bytes.size());
        const auto* const from =
            reinterpret_cast<const unsigned char*>(binary.data()) + packed["byteOffset"].get<std::size_t>();
        EXPECT_EQ(packed["mode"] == "TRIANGLES" ? meshopt_decodeIndexBuffer(bytes.data(), count, stride, from, length)
                                                : meshopt_decodeVertexBuffer(bytes.data(), count, stride, from, length),
                  0);
    }
    return made;
}

/// Two tufts of one shape and one of another.
Json hair(const std::string& layout, bool has_skin) {
    Json body = small_hairstyle();
    body["tufts"].push_back(body["tufts"][0]);
    body["tufts"].push_back({{"points", {{0.1, 0, 0}, {0.2, -0.1, 0}}}, {"widest_at", 100}});
    body["mesh"] = {{"layout", layout}, {"skin", has_skin}};
    if (!has_skin) body.erase("motion");
    return body;
}

std::string answered(const Json& body, bool is_packed, const ForEach& for_each = InOrder()) {
    Request request = json_post("/v1/hairstyles", body.dump());
    if (is_packed) request.query = {{"compression", "meshopt"}};
    const auto found = find_route(request.method, request.path);
    static const Limits limits;
    const Answer answer = std::get<const Route*>(found)->run(request, {limits, for_each, {}});
    return std::string(std::get<Response>(answer).content());
}

TEST(PackedFile, HoldsTheVerticesOfThePlainOne) {
    for (const std::string layout : {"per_tuft", "merged"}) {
        for (const bool has_skin : {true, false}) {
            const Json body = hair(layout, has_skin);
            const Read plain = read(answered(body, false)), packed = read(answered(body, true));
            ASSERT_EQ(packed.json["meshes"].size(), plain.json["meshes"].size());
            for (std::size_t mesh = 0; mesh < plain.json["meshes"].size(); ++mesh) {
                const Json& was = plain.json["meshes"][mesh]["primitives"][0];
                const Json& is = packed.json["meshes"][mesh]["primitives"][0];
                ASSERT_EQ(is, was);  // the same accessors
                for (const auto& [name, accessor] : was["attributes"].items()) {
                    const Json& said = plain.json["accessors"][accessor.get<std::size_t>()];
                    const std::size_t count = said["count"], width = width_of(said);
                    for (std::size_t i = 0; i < count; ++i) {
                        double sum = 0;
                        for (std::size_t k = 0; k < width; ++k) {
                            const double number = packed.number(accessor, i, k), wanted = plain.number(accessor, i, k);
                            sum += number;
                            if (name == "POSITION") continue;  // quantized_test.cpp
                            const double tolerance = name == "NORMAL"      ? 0.51 / 127
                                                     : name == "WEIGHTS_0" ? 1.0 / 255
                                                                           : 1e-5;
                            ASSERT_NEAR(number, wanted, tolerance) << layout << name << i;
                        }
                        if (name == "WEIGHTS_0") {
                            ASSERT_NEAR(sum, 1, 1e-12);
                        }
                    }
                }
            }
        }
    }
}

/// Triangles in any order, each from its least corner on.
std::vector<std::array<double, 3>> triangles_of(const Read& file, const Json& indices) {
    std::vector<std::array<double, 3>> all(
        file.json["accessors"][indices.get<std::size_t>()]["count"].get<std::size_t>() / 3);
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) all[i][k] = file.number(indices, 3 * i + k, 0);
        std::rotate(all[i].begin(), std::min_element(all[i].begin(), all[i].end()), all[i].end());
    }
    std::ranges::sort(all);
    return all;
}

TEST(PackedFile, HoldsTheTrianglesOfThePlainOne) {
    for (const std::string layout : {"per_tuft", "merged"}) {
        Json body = hair(layout, false);
        body["mesh"]["sides"] = 12;
        const Read plain = read(answered(body, false)), packed = read(answered(body, true));
        for (const Json& mesh : plain.json["meshes"]) {
            const Json& indices = mesh["primitives"][0]["indices"];
            EXPECT_EQ(triangles_of(packed, indices), triangles_of(plain, indices));
        }
    }
}

TEST(PackedFile, SaysWhatAReaderMustKnow) {
    const Json json = read(answered(hair("merged", true), true)).json;
    EXPECT_EQ(json["extensionsRequired"], Json::parse(R"(["EXT_meshopt_compression","KHR_mesh_quantization"])"));
    EXPECT_EQ(json["extensionsUsed"], json["extensionsRequired"]);
    ASSERT_EQ(json["buffers"].size(), 2U);
    EXPECT_EQ(json["buffers"][1]["extensions"]["EXT_meshopt_compression"], Json::parse(R"({"fallback":true})"));
    std::size_t end = 0;
    for (const Json& view : json["bufferViews"]) {
        if (view["buffer"] == 0) continue;
        EXPECT_EQ(view.value("byteOffset", std::size_t{0}), end);
        end += (view["byteLength"].get<std::size_t>() + 3) / 4 * 4;
    }
    EXPECT_EQ(json["buffers"][1]["byteLength"], end);
}

TEST(PackedFile, IsTheSameForAnyNumberOfWorkers) {
    Pool pool(4, 4);
    for (const std::string layout : {"per_tuft", "merged"}) {
        const Json body = hair(layout, true);
        EXPECT_EQ(answered(body, true, pool.for_each()), answered(body, true)) << layout;
    }
}

TEST(PackedFile, EndsWhereItIsToldToStop) {
    Request request = json_post("/v1/tufts", hair("merged", false).dump());
    request.query = {{"compression", "meshopt"}};
    std::stop_source source;
    source.request_stop();
    const Answer answer = answer_to(request, source.get_token());  // which nobody will see
    if (const auto* const response = std::get_if<Response>(&answer)) {
        EXPECT_EQ(response->content().substr(0, 4), "glTF");
    }
}

TEST(PackedFile, IsShorter) {
    Json body = hair("merged", false);
    body["mesh"]["rings"] = 4'096;  // indices of four bytes, too
    EXPECT_LT(answered(body, true).size() * 2, answered(body, false).size());
}

}  // namespace
}  // namespace tuftwave::server::gltf
