#include "character/character.hpp"

#include <algorithm>

#include "character/file_limits.hpp"
#include "character/required_extensions.hpp"

namespace tuftwave::server::character {
namespace {

constexpr Range kCoordinate{-1e6, 1e6};  // metres
constexpr Range kScale{-1e6, 1e6};
constexpr Range kComponent{-1e3, 1e3};  // of a quaternion, before it is made a unit one
constexpr double kShortest = 1e-9;      // quaternion
constexpr double kAlike = 1e-3;         // scales that differ by less are one

void check_version(const FileValue& asset) {
    if (!asset.exists()) return asset.refuse(Fault::Kind::kMissing, "an object");
    const FileValue version = asset["version"], least = asset["minVersion"];
    if (!version.exists()) return version.refuse(Fault::Kind::kMissing, "2.0");
    if (!version.text().starts_with("2.")) version.refuse(Fault::Kind::kUnsupported, "2.0");
    if (least.exists() && least.text() != "2.0") least.refuse(Fault::Kind::kUnsupported, "2.0");
}

bool read_placement(const FileValue& node, Node& into) {
    if (const FileValue matrix = node["matrix"]; matrix.exists()) {
        const auto m = matrix.numbers<16>(kCoordinate);
        if (!m) return false;
        const auto column = [&](std::size_t i) { return Vec3{(*m)[4 * i], (*m)[4 * i + 1], (*m)[4 * i + 2]}; };
        into.has_matrix = true;
        into.model = {column(0), column(1), column(2), column(3)};
        if (const auto placement = to_placement(into.model)) {
            into.local = *placement;
        } else {
            into.is_rigid = false;
        }
        return true;
    }
    if (const auto t = node["translation"].numbers<3>(kCoordinate))
        into.local.translation = {(*t)[0], (*t)[1], (*t)[2]};
    if (const auto s = node["scale"].numbers<3>(kScale)) into.local.scale = {(*s)[0], (*s)[1], (*s)[2]};
    if (const auto r = node["rotation"].numbers<4>(kComponent)) {
        const Quat rotation{(*r)[0], (*r)[1], (*r)[2], (*r)[3]};
        if (dot(rotation, rotation) < kShortest) {
            node["rotation"].refuse(Fault::Kind::kDegenerate, "a quaternion with a length");
            return false;
        }
        into.local.rotation = normalized(rotation);
    }
    into.model = to_affine(into.local);
    return true;
}

bool scales_alike(const Vec3& scale) {
    const double least = std::min({scale.x, scale.y, scale.z}), most = std::max({scale.x, scale.y, scale.z});
    return least > 0 && most - least <= kAlike * most;
}

/// Reads nodes and says whose children they are; a second parent is refused where it claims the child.
void read_nodes(const FileValue& nodes, Character& character) {
    const std::size_t count = nodes.size();
    if (count > kFileLimits.nodes)
        return nodes.refuse(Fault::Kind::kTooMany, "at most " + std::to_string(kFileLimits.nodes) + " nodes");
    character.nodes.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const FileValue value = nodes.at(i);
        Node& node = character.nodes[i];
        node.name = value["name"].name();
        node.has_mesh = value["mesh"].exists();
        if (!read_placement(value, node)) return;
        node.children = value["children"].indices(count);
        for (std::size_t c = 0; c < node.children.size(); ++c) {
            Node& child = character.nodes[static_cast<std::size_t>(node.children[c])];
            if (child.parent >= 0)
                return value["children"].at(c).refuse(Fault::Kind::kConflict, "a node that has no other parent");
            child.parent = static_cast<int>(i);
        }
    }
}

/// Scales multiply from parent to child, so that each may be within its range and the place beyond all numbers.
bool is_in_sight(const Vec3& place) {
    return is_within(place.x, kCoordinate) && is_within(place.y, kCoordinate) && is_within(place.z, kCoordinate);
}

/// Orders nodes parents first and places them in model space. Whoever is not reached hangs in a circle.
void place_nodes(const FileValue& nodes, Character& character) {
    for (std::size_t i = 0; i < character.nodes.size(); ++i) {
        if (character.nodes[i].parent < 0) character.order.push_back(static_cast<int>(i));
    }
    for (std::size_t next = 0; next < character.order.size(); ++next) {
        Node& node = character.nodes[static_cast<std::size_t>(character.order[next])];
        node.turn = node.local.rotation;
        if (node.parent >= 0) {
            const Node& parent = character.nodes[static_cast<std::size_t>(node.parent)];
            const bool is_above_rigid = parent.is_rigid && scales_alike(parent.local.scale);
            node.is_rigid = node.is_rigid && is_above_rigid;
            node.model = parent.model * node.model;
            node.turn = parent.turn * node.local.rotation;
        }
        if (!is_in_sight(node.model.origin))
            return nodes.at(static_cast<std::size_t>(character.order[next]))
                .refuse(Fault::Kind::kOutOfRange, "a place within 1000000 metres on each axis, with all that is above");
        for (const int child : node.children) character.order.push_back(child);
    }
    if (character.order.size() == character.nodes.size()) return;
    std::vector<bool> is_placed(character.nodes.size(), false);
    for (const int node : character.order) is_placed[static_cast<std::size_t>(node)] = true;
    const auto lost = std::find(is_placed.begin(), is_placed.end(), false) - is_placed.begin();
    nodes.at(static_cast<std::size_t>(lost)).refuse(Fault::Kind::kConflict, "nodes that form no circle");
}

/// Numbers the nodes in preorder, so that "below" is a comparison.
void number_nodes(Character& character) {
    std::vector<Node>& nodes = character.nodes;
    const auto at = [&](int index) -> Node& { return nodes[static_cast<std::size_t>(index)]; };
    for (auto index = character.order.rbegin(); index != character.order.rend(); ++index) {
        at(*index).last += 1;  // counts its subtree first
        if (at(*index).parent >= 0) at(at(*index).parent).last += at(*index).last;
    }
    std::size_t next = 0;
    for (const int index : character.order) {
        Node& node = at(index);
        if (node.parent < 0) {
            node.first = next;
            next += node.last;
        }
        std::size_t first = node.first + 1;
        for (const int child : node.children) {
            at(child).first = first;
            first += at(child).last;
        }
        node.last += node.first;
    }
}

void read_skins(const FileValue& skins, std::size_t accessors, Character& character) {
    std::size_t joints = 0;
    for (std::size_t i = 0, count = skins.size(); i < count; ++i) {
        Skin& skin = character.skins.emplace_back();
        const FileValue list = skins.at(i)["joints"];
        joints += list.size();
        if (joints > kFileLimits.joints)
            return list.refuse(Fault::Kind::kTooMany,
                               "at most " + std::to_string(kFileLimits.joints) + " joints in all skins");
        skin.joints = list.indices(character.nodes.size());
        skin.inverse_bind_matrices = skins.at(i)["inverseBindMatrices"].index(accessors);
        for (const int joint : skin.joints) character.nodes[static_cast<std::size_t>(joint)].is_joint = true;
    }
}

void read_vrm1(const FileValue& extensions, Character& character) {
    const std::size_t count = character.nodes.size();
    const FileValue bones = extensions["VRMC_vrm"]["humanoid"]["humanBones"];
    for (const std::string& bone : bones.keys()) {
        if (const auto node = bones[bone]["node"].index(count)) character.humanoid[bone] = *node;
    }
    const FileValue springs = extensions["VRMC_springBone"]["springs"];
    for (std::size_t i = 0, springs_count = springs.size(); i < springs_count; ++i) {
        const FileValue joints = springs.at(i)["joints"];
        Spring& spring = character.springs.emplace_back();
        spring.name = springs.at(i)["name"].name();
        for (std::size_t j = 0, joints_count = joints.size(); j < joints_count; ++j) {
            if (const auto node = joints.at(j)["node"].index(count)) spring.joints.push_back(*node);
        }
    }
}

void read_vrm0(const FileValue& vrm, Character& character) {
    const std::size_t count = character.nodes.size();
    const FileValue bones = vrm["humanoid"]["humanBones"];
    for (std::size_t i = 0, bone_count = bones.size(); i < bone_count; ++i) {
        const FileValue bone = bones.at(i);
        if (const auto node = bone["node"].index(count)) character.humanoid.emplace(bone["bone"].name(), *node);
    }
    const FileValue groups = vrm["secondaryAnimation"]["boneGroups"];
    for (std::size_t i = 0, group_count = groups.size(); i < group_count; ++i)
        character.bone_groups.push_back({groups.at(i)["comment"].name(), groups.at(i)["bones"].indices(count)});
}

}  // namespace

std::variant<Character, Fault> read_character(const FileJson& json) {
    std::optional<Fault> fault;
    Character character;
    const FileValue file(&json, "", fault);
    check_version(file["asset"]);
    check_required_extensions(file["extensionsRequired"]);
    if (!fault) read_nodes(file["nodes"], character);
    if (!fault) place_nodes(file["nodes"], character);
    if (!fault) number_nodes(character);
    if (!fault) read_skins(file["skins"], file["accessors"].size(), character);
    if (!fault) {
        const FileValue extensions = file["extensions"];
        const FileValue vrm0 = extensions["VRM"];
        if (extensions["VRMC_vrm"].exists() || extensions["VRMC_springBone"].exists()) {
            read_vrm1(extensions, character);
        } else if (vrm0.exists()) {
            read_vrm0(vrm0, character);
            character.faces_minus_z = true;
        }
    }
    if (fault) return *std::move(fault);
    return character;
}

}  // namespace tuftwave::server::character
