#pragma once

#include <span>
#include <string>
#include <vector>

#include "tuftwave/hairstyle.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/skeleton.hpp"

namespace tuftwave::server::poses {

/// Bones' names, chain by chain, root first. The tip of a chain is no bone and has none.
using BoneNames = std::vector<std::vector<std::string>>;

/// Chains in motion, with a name for every bone.
struct PosedHair {
    std::span<const Chain> chains;
    const HairMotion& motion;
    const BoneNames& names;  ///< UTF-8; unique over all chains
};

/// How each node is turned away from rest by itself, in model axes: what a bone without a rest rotation is turned by,
/// relative to its parent. The first node's parent is at rest.
/// @param rotations  local, one per node and picture, as in ChainMotion
/// @return  as many, in the same order; unit, and as sign-continuous as `rotations`
std::vector<Quat> bone_turns(const Chain& chain, std::span<const Quat> rotations);

/// Names made of allowed characters only, none beginning with a digit, and still unique.
/// @param is_allowed  the others become underscores
/// @param taken       a name that no bone may have
BoneNames legal_names(const BoneNames& names, bool (*is_allowed)(char), const std::string& taken);

/// The shortest decimal that reads back to the same float32, the same in every locale; no minus before zero.
void append_number(std::string& text, double value);

}  // namespace tuftwave::server::poses
