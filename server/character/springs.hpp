#pragma once

#include <vector>

#include "character/character.hpp"
#include "character/file_value.hpp"
#include "character/found_chains.hpp"

namespace tuftwave::server::character {

/// Takes the springs off the chains that a clip moves, since a VRM player runs springs after animations and overwrites
/// them. Springs of other chains stay; a VRM 0.x root takes all below it along.
/// @return  how many springs or roots went
std::size_t remove_springs(FileJson& file, const Character& character, const std::vector<FoundChain>& moved);

/// How many springs or roots would overwrite the clip.
std::size_t count_springs(const Character& character, const std::vector<FoundChain>& moved);

}  // namespace tuftwave::server::character
