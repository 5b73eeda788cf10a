#pragma once

#include <cstddef>

namespace tuftwave::server::character {

/// What a posted file may be; published at /v1/limits.
struct FileLimits {
    std::size_t bytes =
        64 * 1024 * 1024;  ///< VRMs with large textures have 30 MiB; textures are carried, never decoded
    std::size_t json_bytes = 16 * 1024 * 1024;
    std::size_t json_depth = 64;
    std::size_t json_values = 2'000'000;
    std::size_t keys_per_object = 256;
    std::size_t nodes = 65'536;
    std::size_t joints = 262'144;                ///< in all skins
    std::size_t name_bytes = 1'024;              ///< of a node, spring or bone group
    std::size_t json_memory = 64 * 1024 * 1024;  ///< bytes that its JSON may become, by our reckoning
};

inline constexpr FileLimits kFileLimits;

}  // namespace tuftwave::server::character
