#pragma once

#include <string>
#include <variant>
#include <vector>

#include "character/character.hpp"
#include "character/fault.hpp"
#include "character/file_value.hpp"
#include "gltf/clip_keys.hpp"

namespace tuftwave::server::character {

/// A node's rotation in each picture.
struct NodeKeys {
    int node;
    std::vector<Quat> rotations;
};

/// Checks that a clip can be added: the lists it is added to are lists, and the file's buffer is the file's own.
/// @param binary_bytes  of the file's binary chunk
std::optional<Fault> check_clip_fits(const FileJson& file, const std::string& name, std::size_t binary_bytes);

/// Adds a clip that holds each picture until the next one. Nothing that is there moves or changes, but a moved node
/// that states a matrix states the same as translation, rotation and scale, since glTF animates only those.
/// @param file          checked by check_clip_fits
/// @param binary_bytes  of the file's binary chunk
/// @return  the bytes to append to the binary chunk, a multiple of 4
std::string add_held_clip(FileJson& file, const Character& character, const std::vector<NodeKeys>& nodes,
                          const gltf::ClipKeys& keys, const std::string& name, const FileJson& extras,
                          std::size_t binary_bytes);

}  // namespace tuftwave::server::character
