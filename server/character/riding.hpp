#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "character/character.hpp"
#include "character/found_chains.hpp"

namespace tuftwave::server::character {

/// The moving bone that a chain hangs on.
struct Ride {
    std::size_t chain, bone;  ///< index into the chains that move, and into its bones
};

/// Which of the chains that move hang on a bone of another one, at whatever depth.
/// @return  one per chain
std::vector<std::optional<Ride>> find_rides(const Character& character, std::span<const FoundChain> moved);

/// Indices of the chains that move, each behind the one that it hangs on.
std::vector<std::size_t> riding_order(const Character& character, std::span<const FoundChain> moved);

}  // namespace tuftwave::server::character
