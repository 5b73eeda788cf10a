#pragma once

#include <variant>

#include "api/exchange.hpp"
#include "api/problem.hpp"
#include "character/character.hpp"
#include "character/file_value.hpp"
#include "character/found_chains.hpp"
#include "character/glb.hpp"
#include "tuftwave/limits.hpp"

namespace tuftwave::server {

/// A character that somebody posted.
struct Upload {
    character::Glb glb;  ///< points into the request's body
    character::FileJson file;
    character::Character character;
    character::FoundChains found;
};

/// Reads a GLB or VRM from the request's body. No file or address that it names is opened, no picture decoded.
/// @return  the character and its chains, or unsupported_media_type, malformed, what parse_guarded says, or what is
///          wrong in the file, with a JSON pointer into its glTF
std::variant<Upload, Problem> read_character(const Request& request, const Limits& limits);

/// What is wrong with a file as a problem.
Problem to_problem(const character::Fault& fault);

}  // namespace tuftwave::server
