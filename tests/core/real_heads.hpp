#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "real_strokes.hpp"
#include "tuftwave/scalp_shape.hpp"

/// A head that nobody in this project made, see tests/data/README.md.
namespace tuftwave::test {

/// One primitive of the MakeHuman head, metres from the floor, face to +Z. @param material  skin, scalp or eyes
inline ScalpMesh mpfb_head(const std::string& material) {
    const std::string bytes = file_bytes(kDataDirectory / "heads" / "mpfb_head_base.glb");
    std::uint32_t json_size = 0;
    std::memcpy(&json_size, &bytes.at(12), 4);
    const nlohmann::json gltf = nlohmann::json::parse(bytes.substr(20, json_size));
    const auto data_of = [&](const nlohmann::json& accessor) {
        const nlohmann::json& view = gltf.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
        return bytes.data() + 28 + json_size + view.value("byteOffset", 0);
    };
    ScalpMesh mesh;
    for (const nlohmann::json& primitive : gltf.at("meshes").at(0).at("primitives")) {
        const auto index = primitive.at("material").get<std::size_t>();
        if (gltf.at("materials").at(index).at("name") != material) continue;
        const nlohmann::json& positions =
            gltf.at("accessors").at(primitive.at("attributes").at("POSITION").get<std::size_t>());
        const nlohmann::json& indices = gltf.at("accessors").at(primitive.at("indices").get<std::size_t>());
        for (std::size_t i = 0; i < positions.at("count"); ++i) {
            float xyz[3];
            std::memcpy(xyz, data_of(positions) + i * sizeof xyz, sizeof xyz);
            mesh.positions.push_back({xyz[0], xyz[1], xyz[2]});
        }
        for (std::size_t i = 0; i + 2 < indices.at("count"); i += 3) {
            std::uint16_t corners[3];
            std::memcpy(corners, data_of(indices) + 2 * i, sizeof corners);
            mesh.triangles.push_back({corners[0], corners[1], corners[2]});
        }
    }
    return mesh;
}

}  // namespace tuftwave::test
