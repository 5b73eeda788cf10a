#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "character/fault.hpp"

namespace tuftwave::server::character {

/// The parts of a binary glTF file, pointing into it.
struct Glb {
    std::string_view json;    ///< with its padding
    std::string_view binary;  ///< with its padding; empty where the file has none
    std::string_view others;  ///< the chunks behind, with their headers: other people's, to be kept
};

/// Takes a GLB apart. Every length is checked against the bytes that are there before it is used.
/// @return  its parts, or a malformed fault
std::variant<Glb, Fault> split_glb(std::string_view file);

/// Puts a GLB together.
/// @param json    padded here
/// @param added   bytes that follow `binary` in the binary chunk, a multiple of 4
/// @param others  as in Glb
std::string join_glb(std::string_view json, std::string_view binary, std::string_view added, std::string_view others);

}  // namespace tuftwave::server::character
