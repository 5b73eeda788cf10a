#pragma once

#include <variant>
#include <vector>

#include "api/character_settings.hpp"
#include "api/formats.hpp"
#include "api/operation.hpp"
#include "api/read_character.hpp"
#include "character/clip.hpp"
#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server {

/// The chains of a character that move, and how.
struct MovedCharacter {
    std::vector<std::size_t> indices;          ///< into upload.found.chains
    std::vector<character::FoundChain> found;  ///< the chains themselves
    std::vector<Chain> chains;                 ///< the same, as core moves them
    HairMotion motion;
};

/// Chooses chains and moves them.
/// @param format  may prescribe the frame rate
std::variant<MovedCharacter, Problem> move_character(const Upload& upload, const CharacterSettings& settings,
                                                     Format format, const Context& context);

/// Each bone's node and its rotations, as the file's own nodes have them.
std::vector<character::NodeKeys> node_keys(const Upload& upload, const MovedCharacter& moved);

}  // namespace tuftwave::server
