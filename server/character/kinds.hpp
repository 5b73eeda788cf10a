#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "character/character.hpp"

namespace tuftwave::server::character {

/// What a chain looks like.
enum class Kind { kHair, kSkirt, kRibbon, kUnknown };

/// What a name says about the part of a character that it stands for.
enum class NameHint { kHair, kSkirt, kRibbon, kFace, kOther };

/// What a name says in Japanese (half-width kana too), English or their mixtures; nothing for most names, and for
/// UUIDs. Hints are what they are: most real files name their chains in no such way.
std::optional<NameHint> hint_of(std::string_view name);

/// The node that the head is: VRM's, else one called so. @return  -1 if nothing says
int find_head(const Character& character);

}  // namespace tuftwave::server::character
