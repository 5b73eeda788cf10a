#include "character/found_chains.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "character/judge.hpp"

namespace tuftwave::server::character {
namespace {

constexpr double kTipShare = 0.05;  // of the last bone: nearer than this, its own vertices make no bone of their own
constexpr double kShortest = 1e-6;  // metres

class Finder {
  public:
    Finder(const Character& character, const std::vector<OwnVertices>& own, std::size_t most_nodes)
        : character_(character), own_(own), most_nodes_(most_nodes), taken_(character.nodes.size(), false) {}

    FoundChains find() {
        found_.head = find_head(character_);
        mark_body();
        for (std::size_t i = 0; i < character_.springs.size(); ++i) add_spring(i);
        for (std::size_t i = 0; i < character_.bone_groups.size(); ++i) {
            for (const int root : character_.bone_groups[i].roots) split(root, FoundBy::kVrm0BoneGroup, i);
        }
        for (const int node : character_.order) {
            if (is_joint_run_root(node)) split(node, FoundBy::kSkin, {});
        }
        return std::move(found_);
    }

  private:
    const Node& node(int index) const { return character_.nodes[static_cast<std::size_t>(index)]; }
    Vec3 place(int index) const { return node(index).model.origin; }
    const OwnVertices& own(int index) const { return own_[static_cast<std::size_t>(index)]; }
    bool is_taken(int index) const { return taken_[static_cast<std::size_t>(index)]; }

    /// Once, however many springs name it.
    void skip(int index, std::string_view reason) {
        if (skipped_.insert({index, reason}).second) found_.skipped.push_back({index, reason});
    }

    /// What hangs on a bone: joints; below the last joint whatever carries no mesh.
    std::vector<int> bones_below(int index) const {
        std::vector<int> joints, others;
        for (const int child : node(index).children) {
            if (node(child).is_joint) {
                joints.push_back(child);
            } else if (!node(child).has_mesh) {
                others.push_back(child);
            }
        }
        return joints.empty() ? others : joints;
    }

    /// The body: VRM's bones or, without VRM, the head and wherever bones branch outside it; and all that is above.
    void mark_body() {
        body_.assign(character_.nodes.size(), false);
        for (const auto& [name, bone] : character_.humanoid) body_[static_cast<std::size_t>(bone)] = true;
        if (found_.head >= 0) body_[static_cast<std::size_t>(found_.head)] = true;
        for (auto index = character_.order.rbegin(); index != character_.order.rend(); ++index) {
            const auto slot = static_cast<std::size_t>(*index);
            const bool is_below_head = found_.head >= 0 && is_below(node(*index), node(found_.head));
            if (character_.humanoid.empty() && !is_below_head && bones_below(*index).size() > 1) body_[slot] = true;
            if (body_[slot] && node(*index).parent >= 0) body_[static_cast<std::size_t>(node(*index).parent)] = true;
        }
    }

    bool is_joint_run_root(int index) const {
        if (!node(index).is_joint || is_taken(index) || body_[static_cast<std::size_t>(index)]) return false;
        const int parent = node(index).parent;
        return parent < 0 || !node(parent).is_joint || body_[static_cast<std::size_t>(parent)];
    }

    /// A spring's joints in the order given, each somewhere below the one before.
    void add_spring(std::size_t spring) {
        const std::vector<int>& joints = character_.springs[spring].joints;
        if (joints.empty()) return;
        for (std::size_t i = 0; i < joints.size(); ++i) {
            if (is_taken(joints[i])) return skip(joints.front(), "in_two_springs");
            if (i > 0 && !is_below(node(joints[i]), node(joints[i - 1]))) return skip(joints.front(), "broken_spring");
        }
        add(joints, FoundBy::kVrm1Spring, spring, {});
    }

    /// Follows bones down from `root`. Where they branch the chain ends, and each branch begins another.
    void split(int root, FoundBy found_by, std::optional<std::size_t> source) {
        std::vector<std::pair<int, std::optional<std::size_t>>> waiting{{root, {}}};
        while (!waiting.empty()) {
            auto [first, branches_from] = waiting.back();
            waiting.pop_back();
            if (is_taken(first)) continue;
            std::vector<int> run{first};
            std::vector<int> below = bones_below(first);
            while (below.size() == 1 && !is_taken(below.front())) {
                run.push_back(below.front());
                below = bones_below(run.back());
            }
            const bool is_branching = below.size() > 1;
            if (is_branching) found_.branchings.push_back(run.back());
            const std::size_t before = found_.chains.size();
            add(run, found_by, source, branches_from, is_branching);
            const bool is_added = found_.chains.size() > before;
            for (auto child = below.rbegin(); child != below.rend() && is_branching; ++child)
                waiting.push_back({*child, is_added ? std::optional(before) : branches_from});
        }
    }

    void add(const std::vector<int>& run, FoundBy found_by, std::optional<std::size_t> source,
             std::optional<std::size_t> branches_from, bool is_branching = false) {
        for (const int index : run) taken_[static_cast<std::size_t>(index)] = true;
        FoundChain chain;
        chain.name = node(run.front()).name;
        chain.found_by = found_by;
        chain.source = source;
        chain.branches_from = branches_from;
        chain.bones = run;
        if (!is_branching && goes_on(run)) {
            const OwnVertices& last = own(run.back());
            const Vec3 from = place(run.back()), way = last.middle - from;
            chain.tip = from + last.reach / length(way) * way;
        } else if (run.size() > 1) {
            chain.tip_node = run.back();
            chain.tip = place(run.back());
            chain.bones.pop_back();
        } else {
            if (!is_branching) skip(run.front(), "no_length");
            return;
        }
        if (const std::string_view wrong = fault_of(chain); !wrong.empty()) return skip(run.front(), wrong);
        found_.chains.push_back(std::move(chain));
    }

    /// Whether the hair goes on behind the last node, which then is a bone and not the tip.
    bool goes_on(const std::vector<int>& run) const {
        const OwnVertices& last = own(run.back());
        if (last.count == 0 || length(last.middle - place(run.back())) < kShortest) return false;
        const double bone = run.size() > 1 ? length(place(run.back()) - place(run[run.size() - 2])) : 0;
        return last.reach > kTipShare * bone;
    }

    double length_of(const FoundChain& chain) const {
        double whole = length(chain.tip - place(chain.bones.back()));
        for (std::size_t i = 1; i < chain.bones.size(); ++i)
            whole += length(place(chain.bones[i]) - place(chain.bones[i - 1]));
        return whole;
    }

    /// Why core cannot move a chain, "" if it can.
    std::string_view fault_of(const FoundChain& chain) const {
        if (chain.bones.size() + 1 > most_nodes_) return "too_long";
        if (length_of(chain) < kShortest) return "no_length";
        const auto is_sheared = [&](int bone) { return !node(bone).is_rigid; };
        return std::any_of(chain.bones.begin(), chain.bones.end(), is_sheared) ? "sheared" : "";
    }

    const Character& character_;
    const std::vector<OwnVertices>& own_;
    const std::size_t most_nodes_;
    std::vector<bool> taken_, body_;
    std::set<std::pair<int, std::string_view>> skipped_;
    FoundChains found_;
};

/// The bone before, or the node that the first one hangs on; -1 if there is none.
int before(const Character& character, const FoundChain& chain, std::size_t bone) {
    return bone > 0 ? chain.bones[bone - 1] : character.nodes[static_cast<std::size_t>(chain.bones[0])].parent;
}

Quat turn_of(const Character& character, int node) {
    return node < 0 ? Quat{} : character.nodes[static_cast<std::size_t>(node)].turn;
}

}  // namespace

FoundChains find_chains(const Character& character, const std::vector<OwnVertices>& own, std::size_t most_nodes) {
    FoundChains found = Finder(character, own, most_nodes).find();
    judge_chains(character, found);
    return found;
}

Chain to_chain(const Character& character, const FoundChains& found, const FoundChain& from) {
    Chain chain;
    chain.name = from.name;
    chain.parent_rotation = normalized(turn_of(character, before(character, from, 0)));
    for (std::size_t i = 0; i < from.bones.size(); ++i) {
        const Quat above = turn_of(character, before(character, from, i));
        chain.nodes.push_back(character.nodes[static_cast<std::size_t>(from.bones[i])].model.origin);
        chain.rest_rotations.push_back(normalized(inverse(above) * turn_of(character, from.bones[i])));
    }
    chain.nodes.push_back(from.tip);
    chain.rest_rotations.emplace_back();
    const Vec3 away = chain.nodes.front() - found.head_center;
    if (found.head >= 0 && length(away) > kShortest) chain.outward = normalized(away);
    return chain;
}

Quat to_node_rotation(const Character& character, const FoundChain& chain, std::size_t bone, const Quat& rotation) {
    const int parent = character.nodes[static_cast<std::size_t>(chain.bones[bone])].parent;
    const Quat above = turn_of(character, before(character, chain, bone));
    return inverse(inverse(above) * turn_of(character, parent)) * rotation;
}

}  // namespace tuftwave::server::character
