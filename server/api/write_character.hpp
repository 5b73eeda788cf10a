#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "api/pose_text.hpp"
#include "api/read_character.hpp"
#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server {

/// A chain of a character: its bones, how it was found and what it looks like. @param index  into upload.found.chains
nlohmann::ordered_json found_chain_json(const Upload& upload, std::size_t index);

/// All of them, what was left out, and where the head is: an answer's text.
std::string found_chains_text(const Upload& upload);

/// Every moved chain's poses: the rotation of each bone's node, how it is turned away from rest, and
/// where bones and tip are. A chain that hangs on another one moves along with it.
/// @param chains  the same, as core moved them
/// Incomplete once `stop` is set.
std::vector<ChainPoses> character_poses(const Upload& upload, std::span<const character::FoundChain> moved,
                                        std::span<const Chain> chains, const HairMotion& motion,
                                        const std::stop_token& stop);

}  // namespace tuftwave::server
