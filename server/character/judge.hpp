#pragma once

#include "character/found_chains.hpp"

namespace tuftwave::server::character {

/// Says of every chain what it looks like and why, drops what belongs to the face or the body, and places the head's
/// middle. Ancestry decides before names, since most files name nothing; names decide what hangs on the head.
void judge_chains(const Character& character, FoundChains& found);

}  // namespace tuftwave::server::character
