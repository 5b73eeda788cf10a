#include "character/judge.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace tuftwave::server::character {
namespace {

constexpr double kHighShare = 0.75;     // of the skeleton's height: where a head is if nothing says so
constexpr std::size_t kSkirtBones = 3;  // chains side by side around the hips that make a skirt

class Judge {
  public:
    Judge(const Character& character, const FoundChains& found) : character_(character), found_(found) {
        for (const FoundChain& chain : found.chains) ++beside_[root(chain).parent];
        std::vector<double> heights;
        for (const Node& node : character.nodes) {
            if (node.is_joint) heights.push_back(node.model.origin.y);
        }
        if (heights.empty()) return;
        const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
        high_ = *lowest + kHighShare * (*highest - *lowest);
    }

    bool is_below_head(const FoundChain& chain) const {
        return found_.head >= 0 && is_below(root(chain), node(found_.head));
    }

    /// Sets kind and because. @return  why the chain is none to offer, "" if it is
    std::string_view judge(FoundChain& chain) const {
        constexpr std::string_view kSources[] = {"vrm1_spring", "vrm0_bone_group", "skin_joints"};
        const bool is_spring = chain.found_by != FoundBy::kSkin;
        chain.because.push_back(kSources[static_cast<std::size_t>(chain.found_by)]);
        if (is_below_head(chain)) chain.because.push_back("below_head");
        const std::optional<NameHint> named = hint(chain);
        if (named == NameHint::kFace && !is_spring) return "face";
        if (named && *named != NameHint::kFace) return judge_by_name(chain, *named);
        return judge_by_place(chain);
    }

  private:
    const Node& node(int index) const { return character_.nodes[static_cast<std::size_t>(index)]; }
    const Node& root(const FoundChain& chain) const { return node(chain.bones.front()); }

    std::optional<NameHint> hint(const FoundChain& chain) const {
        if (const auto named = hint_of(chain.name)) return named;
        if (chain.found_by == FoundBy::kVrm1Spring) return hint_of(character_.springs[*chain.source].name);
        if (chain.found_by == FoundBy::kVrm0BoneGroup) return hint_of(character_.bone_groups[*chain.source].name);
        return {};
    }

    std::string_view judge_by_name(FoundChain& chain, NameHint named) const {
        constexpr std::pair<Kind, std::string_view> kMeanings[] = {{Kind::kHair, "name_says_hair"},
                                                                   {Kind::kSkirt, "name_says_skirt"},
                                                                   {Kind::kRibbon, "name_says_ribbon"},
                                                                   {Kind::kUnknown, "name_says_face"},
                                                                   {Kind::kUnknown, "name_says_other"}};
        const auto& [kind, word] = kMeanings[static_cast<std::size_t>(named)];
        chain.kind = kind;
        chain.because.push_back(word);
        const bool is_body = kind == Kind::kUnknown && chain.found_by == FoundBy::kSkin && !is_below_head(chain);
        return is_body ? "body" : "";
    }

    std::string_view judge_by_place(FoundChain& chain) const {
        if (is_below_head(chain)) {
            chain.kind = Kind::kHair;
        } else if (found_.head < 0 && root(chain).model.origin.y > high_) {
            chain.kind = Kind::kHair;
            chain.because.push_back("at_head_height");
        } else if (is_around_hips(chain)) {
            chain.kind = Kind::kSkirt;
            chain.because.push_back("around_hips");
        } else if (chain.found_by == FoundBy::kSkin && found_.head >= 0) {
            return "body";
        }
        return "";
    }

    bool is_around_hips(const FoundChain& chain) const {
        const auto hips = character_.humanoid.find("hips");
        const int parent = root(chain).parent;
        const bool hangs = chain.tip.y < root(chain).model.origin.y;
        return hangs && hips != character_.humanoid.end() && parent == hips->second &&
               beside_.at(parent) >= kSkirtBones;
    }

    const Character& character_;
    const FoundChains& found_;
    std::map<int, std::size_t> beside_;  // chains by what they hang on
    double high_ = 0;
};

/// A head's bone lies where neck and skull meet; the middle is taken half as high as the highest root above it.
Vec3 head_center(const Character& character, const FoundChains& found, const Judge& judge) {
    const Vec3 bone = character.nodes[static_cast<std::size_t>(found.head)].model.origin;
    double rise = 0;
    for (const FoundChain& chain : found.chains) {
        if (judge.is_below_head(chain))
            rise =
                std::max(rise, character.nodes[static_cast<std::size_t>(chain.bones.front())].model.origin.y - bone.y);
    }
    return bone + Vec3{0, rise / 2, 0};
}

}  // namespace

void judge_chains(const Character& character, FoundChains& found) {
    const Judge judge(character, found);
    if (found.head >= 0) found.head_center = head_center(character, found, judge);
    std::vector<FoundChain> kept;
    std::vector<std::optional<std::size_t>> places(found.chains.size());
    std::vector<std::string_view> reasons;
    for (FoundChain& chain : found.chains) reasons.push_back(judge.judge(chain));
    for (std::size_t i = 0; i < found.chains.size(); ++i) {
        FoundChain& chain = found.chains[i];
        if (!reasons[i].empty()) {
            found.skipped.push_back({chain.bones.front(), reasons[i]});
            continue;
        }
        if (chain.branches_from) chain.branches_from = places[*chain.branches_from];
        places[i] = kept.size();
        kept.push_back(std::move(chain));
    }
    found.chains = std::move(kept);
}

}  // namespace tuftwave::server::character
