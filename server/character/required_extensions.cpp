#include "character/required_extensions.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace tuftwave::server::character {
namespace {

/// They speak of materials, textures, lights and avatars, or are read here.
constexpr std::array<std::string_view, 15> kKnown{"EXT_texture_avif",      "EXT_texture_webp",
                                                  "KHR_animation_pointer", "KHR_lights_punctual",
                                                  "KHR_mesh_quantization", "KHR_node_visibility",
                                                  "KHR_texture_basisu",    "KHR_texture_transform",
                                                  "KHR_xmp_json_ld",       "VRM",
                                                  "VRMC_springBone",       "VRMC_vrm",
                                                  "VRMC_node_constraint",  "VRMC_springBone_extended_collider",
                                                  "VRMC_springBone_limit"};
constexpr std::array<std::string_view, 2> kKnownBeginnings{"KHR_materials_", "VRMC_materials_"};

bool is_known(std::string_view name) {
    const auto begins = [&](std::string_view beginning) { return name.starts_with(beginning); };
    return std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end() ||
           std::any_of(kKnownBeginnings.begin(), kKnownBeginnings.end(), begins);
}

}  // namespace

void check_required_extensions(const FileValue& required) {
    for (std::size_t i = 0, count = required.size(); i < count; ++i) {
        const FileValue name = required.at(i);
        if (!is_known(name.text()))
            return name.refuse(Fault::Kind::kUnsupported,
                               "an extension of materials, textures or VRM; save the file without this one");
    }
}

}  // namespace tuftwave::server::character
