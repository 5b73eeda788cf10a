#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "character/affine.hpp"
#include "character/fault.hpp"
#include "character/file_value.hpp"

namespace tuftwave::server::character {

/// A node of the file, as it rests.
struct Node {
    std::string name;
    int parent = -1;  ///< -1 is none
    std::vector<int> children;
    Placement local;
    bool has_matrix = false;  ///< the file states a matrix instead
    bool has_mesh = false;
    bool is_joint = false;            ///< of some skin
    Affine model;                     ///< in the file's model space
    Quat turn;                        ///< the rotation of `model`
    bool is_rigid = true;             ///< what is above only rotates, moves and scales alike in all directions
    std::size_t first = 0, last = 0;  ///< numbers of its descendants in preorder, itself first, the end excluded
};

/// A spring of VRM 1.0: a chain of joints, root first, others may lie between.
struct Spring {
    std::string name;
    std::vector<int> joints;
};

/// A bone group of VRM 0.x: everything below its roots sways.
struct BoneGroup {
    std::string name;
    std::vector<int> roots;
};

/// A skin's joints and the accessor of their inverse bind matrices.
struct Skin {
    std::vector<int> joints;
    std::optional<int> inverse_bind_matrices;
};

/// What chains are found in.
struct Character {
    std::vector<Node> nodes;
    std::vector<int> order;  ///< nodes, parents before children
    std::vector<Skin> skins;
    std::map<std::string, int> humanoid;  ///< VRM's bone names to nodes; empty without VRM
    std::vector<Spring> springs;
    std::vector<BoneGroup> bone_groups;
    bool faces_minus_z = false;  ///< as VRM 0.x does
};

/// Whether a node hangs below another one, at any depth.
inline bool is_below(const Node& node, const Node& ancestor) {
    return node.first > ancestor.first && node.first < ancestor.last;
}

/// Reads what matters of a glTF file: version, required extensions, nodes, skins and what VRM says of them. Ranges,
/// counts, cycles and double parents are checked, so that whoever uses the result need not.
/// @return  the character, or the first thing that is wrong
std::variant<Character, Fault> read_character(const FileJson& file);

}  // namespace tuftwave::server::character
