#include "character/springs.hpp"

#include <algorithm>
#include <set>

namespace tuftwave::server::character {
namespace {

using Nodes = std::set<int>;

Nodes moved_nodes(const std::vector<FoundChain>& moved) {
    Nodes nodes;
    for (const FoundChain& chain : moved) nodes.insert(chain.bones.begin(), chain.bones.end());
    return nodes;
}

/// Whether a spring of VRM 1.0 turns one of the nodes; its last joint does not turn.
bool overwrites(const Spring& spring, const Nodes& moved) {
    if (spring.joints.empty()) return false;
    return std::any_of(spring.joints.begin(), spring.joints.end() - 1,
                       [&](int joint) { return moved.contains(joint); });
}

/// Whether everything below a root of VRM 0.x has one of the nodes in it.
bool overwrites(int root, const Character& character, const std::vector<std::size_t>& moved_numbers) {
    const Node& node = character.nodes[static_cast<std::size_t>(root)];
    const auto next = std::lower_bound(moved_numbers.begin(), moved_numbers.end(), node.first);
    return next != moved_numbers.end() && *next < node.last;
}

std::vector<std::size_t> preorder_numbers(const Character& character, const Nodes& nodes) {
    std::vector<std::size_t> numbers;
    for (const int node : nodes) numbers.push_back(character.nodes[static_cast<std::size_t>(node)].first);
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

/// Takes items out of a list; a list that becomes empty goes too, since VRM's schemas want none.
template <class IsGone>
void remove_items(FileJson& owner, const char* list, IsGone is_gone) {
    if (!owner.contains(list)) return;
    FileJson kept = FileJson::array();
    const std::size_t count = owner[list].size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!is_gone(i)) kept.push_back(std::move(owner[list][i]));
    }
    if (kept.empty() && count > 0) {
        owner.erase(list);
    } else {
        owner[list] = std::move(kept);
    }
}

}  // namespace

std::size_t count_springs(const Character& character, const std::vector<FoundChain>& moved) {
    const Nodes nodes = moved_nodes(moved);
    const std::vector<std::size_t> numbers = preorder_numbers(character, nodes);
    std::size_t count = 0;
    for (const Spring& spring : character.springs) count += overwrites(spring, nodes) ? 1 : 0;
    for (const BoneGroup& group : character.bone_groups) {
        for (const int root : group.roots) count += overwrites(root, character, numbers) ? 1 : 0;
    }
    return count;
}

std::size_t remove_springs(FileJson& file, const Character& character, const std::vector<FoundChain>& moved) {
    const std::size_t count = count_springs(character, moved);
    if (count == 0) return 0;
    const Nodes nodes = moved_nodes(moved);
    if (!character.springs.empty()) {
        remove_items(file["extensions"]["VRMC_springBone"], "springs",
                     [&](std::size_t i) { return overwrites(character.springs[i], nodes); });
        return count;
    }
    const std::vector<std::size_t> numbers = preorder_numbers(character, nodes);
    FileJson& secondary = file["extensions"]["VRM"]["secondaryAnimation"];
    for (std::size_t g = 0; g < character.bone_groups.size(); ++g) {
        const std::vector<int>& roots = character.bone_groups[g].roots;
        remove_items(secondary["boneGroups"][g], "bones",
                     [&](std::size_t i) { return overwrites(roots[i], character, numbers); });
    }
    remove_items(secondary, "boneGroups", [&](std::size_t i) {
        return !character.bone_groups[i].roots.empty() && !secondary["boneGroups"][i].contains("bones");
    });
    return count;
}

}  // namespace tuftwave::server::character
