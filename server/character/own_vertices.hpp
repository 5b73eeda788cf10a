#pragma once

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "character/character.hpp"

namespace tuftwave::server::character {

/// The vertices that follow one joint more than all others.
struct OwnVertices {
    std::size_t count = 0;
    Vec3 middle;       ///< their mean, model space, at rest
    double reach = 0;  ///< from the joint to the farthest, metres
};

/// Looks at every skinned vertex. glTF keeps no bone's length: where a chain's last joint has vertices of its own, they
/// tell how far the hair goes on behind it.
/// @return  one per node, or what is wrong with the file: too many vertices in all, or data outside the file. A skin
///          whose data lies elsewhere is passed over.
std::variant<std::vector<OwnVertices>, Fault> find_own_vertices(const FileJson& file, std::string_view binary,
                                                                const Character& character, std::size_t most_vertices);

}  // namespace tuftwave::server::character
