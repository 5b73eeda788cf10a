#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "api/problem.hpp"
#include "character/found_chains.hpp"

namespace tuftwave::server {

/// Which of a character's chains are wanted.
struct ChainChoice {
    std::string chains;  ///< indices and names, separated by commas; * and ? stand for any text and any character
    std::string kinds;   ///< words of kKinds, separated by commas
};

/// @return  indices of the wanted chains, each once, in the file's order; or not_a_choice where a word fits no chain,
///          conflict where both are given, too_few where nothing is left, too_many where it would take long to compare
std::variant<std::vector<std::size_t>, Problem> choose_chains(const character::FoundChains& found,
                                                              const ChainChoice& choice);

}  // namespace tuftwave::server
