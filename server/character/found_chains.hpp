#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "character/character.hpp"
#include "character/kinds.hpp"
#include "character/own_vertices.hpp"
#include "tuftwave/skeleton.hpp"

namespace tuftwave::server::character {

/// What a chain was found by.
enum class FoundBy { kVrm1Spring, kVrm0BoneGroup, kSkin };

/// A run of bones that could be hair.
struct FoundChain {
    std::string name;  ///< its first bone's
    Kind kind = Kind::kUnknown;
    FoundBy found_by = FoundBy::kSkin;
    std::vector<std::string_view> because;     ///< stable words
    std::vector<int> bones;                    ///< nodes that turn, root first; nodes between them do not bend
    std::optional<int> tip_node;               ///< the node at the end, which does not turn
    Vec3 tip;                                  ///< where the chain ends, model space
    std::optional<std::size_t> source;         ///< index of the spring or bone group
    std::optional<std::size_t> branches_from;  ///< index of the chain at whose end it begins
};

/// Something that looked like a chain and was not taken.
struct Skipped {
    int node;
    std::string_view reason;  ///< a stable word
};

struct FoundChains {
    int head = -1;     ///< node, -1 if nothing says which
    Vec3 head_center;  ///< what hair grows away from, model space
    std::vector<FoundChain> chains;
    std::vector<Skipped> skipped;
    std::vector<int> branchings;  ///< nodes where a chain was split
};

/// Finds every unbranched chain that could be hair: first those that VRM's springs name, then runs of joints. Where
/// bones branch the chain ends, and every branch is a chain of its own.
FoundChains find_chains(const Character& character, const std::vector<OwnVertices>& own, std::size_t most_nodes);

/// The chain as core moves it: positions in model space, rotations relative to the bone before.
Chain to_chain(const Character& character, const FoundChains& found, const FoundChain& chain);

/// What a node's rotation must be so that its bone has `rotation` relative to the bone before.
/// @param bone  index into chain.bones
Quat to_node_rotation(const Character& character, const FoundChain& chain, std::size_t bone, const Quat& rotation);

}  // namespace tuftwave::server::character
