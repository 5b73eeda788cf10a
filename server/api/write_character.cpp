#include "api/write_character.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "api/choices.hpp"
#include "api/write_nouns.hpp"
#include "character/riding.hpp"
#include "tuftwave/motion.hpp"

namespace tuftwave::server {
namespace {

using Json = nlohmann::ordered_json;
using character::FoundBy;
using character::FoundChain;

const character::Node& node_of(const Upload& upload, int index) {
    return upload.character.nodes[static_cast<std::size_t>(index)];
}

Vec3 place_of(const Upload& upload, int index) { return node_of(upload, index).model.origin; }

Json named_node_json(const Upload& upload, int index) {
    return {{"node", index}, {"name", node_of(upload, index).name}};
}

Json bones_json(const Upload& upload, const FoundChain& chain) {
    Json bones = Json::array();
    for (std::size_t i = 0; i < chain.bones.size(); ++i) {
        const bool is_last = i + 1 == chain.bones.size();
        const Vec3 start = place_of(upload, chain.bones[i]);
        const Vec3 end = is_last ? chain.tip : place_of(upload, chain.bones[i + 1]);
        Json bone = named_node_json(upload, chain.bones[i]);
        bone["position"] = pose_json(start);
        bone["length"] = short_number(length(end - start));
        bones.push_back(std::move(bone));
    }
    return bones;
}

Json tip_json(const Upload& upload, const FoundChain& chain) {
    Json tip = chain.tip_node ? named_node_json(upload, *chain.tip_node) : Json::object();
    tip["position"] = pose_json(chain.tip);
    return tip;
}

Json skipped_json(const Upload& upload) {
    Json skipped = Json::array();
    for (const character::Skipped& left : upload.found.skipped) {
        Json json = named_node_json(upload, left.node);
        json["reason"] = left.reason;
        skipped.push_back(std::move(json));
    }
    return skipped;
}

/// One chain in one picture, model space; a place and a turn away from rest per node.
struct Pose {
    std::vector<Vec3> positions;
    std::vector<Quat> turns;
};

/// Every chain's pose in every picture: [chain][picture].
using Poses = std::vector<std::vector<Pose>>;

std::vector<Pose> own_poses(const Chain& chain, const ChainMotion& motion) {
    const std::size_t nodes = chain.nodes.size();
    const std::vector<Quat> turns = model_turns(chain, motion.rotations);
    std::vector<Pose> poses;
    for (std::size_t first = 0; first < turns.size(); first += nodes) {
        const auto begin = turns.begin() + static_cast<std::ptrdiff_t>(first);
        poses.push_back({node_positions(chain, std::span(motion.rotations).subspan(first, nodes)),
                         {begin, begin + static_cast<std::ptrdiff_t>(nodes)}});
    }
    return poses;
}

/// Moves a chain along with the bone that it hangs on.
void carry(std::vector<Pose>& poses, const std::vector<Pose>& carriers, std::size_t bone, const Vec3& rest) {
    for (std::size_t n = 0; n < poses.size(); ++n) {
        const Quat& turn = carriers[n].turns[bone];
        for (Vec3& place : poses[n].positions) place = carriers[n].positions[bone] + rotated(turn, place - rest);
        for (std::size_t i = 0; i < poses[n].turns.size(); ++i) {
            Quat& own = poses[n].turns[i];
            own = turn * own;
            if (n == 0 ? own.w < 0 : dot(own, poses[n - 1].turns[i]) < 0) own = -own;
        }
    }
}

Poses all_poses(const Upload& upload, std::span<const FoundChain> moved, std::span<const Chain> chains,
                const HairMotion& motion) {
    Poses poses;
    for (std::size_t c = 0; c < chains.size(); ++c) poses.push_back(own_poses(chains[c], motion.chains[c]));
    const auto rides = character::find_rides(upload.character, moved);
    for (const std::size_t c : character::riding_order(upload.character, moved)) {
        if (rides[c])
            carry(poses[c], poses[rides[c]->chain], rides[c]->bone, chains[rides[c]->chain].nodes[rides[c]->bone]);
    }
    return poses;
}

}  // namespace

Json found_chain_json(const Upload& upload, std::size_t index) {
    const FoundChain& chain = upload.found.chains[index];
    Json json{{"index", index},
              {"name", chain.name},
              {"kind", word_of(kKinds, chain.kind)},
              {"found_by", word_of(kFoundBy, chain.found_by)},
              {"because", chain.because},
              {"bones", bones_json(upload, chain)},
              {"tip", tip_json(upload, chain)}};
    if (const int parent = node_of(upload, chain.bones.front()).parent; parent >= 0)
        json["parent"] = named_node_json(upload, parent);
    if (chain.found_by == FoundBy::kVrm1Spring) json["spring"] = *chain.source;
    if (chain.found_by == FoundBy::kVrm0BoneGroup) json["bone_group"] = *chain.source;
    if (chain.branches_from) json["branches_from"] = *chain.branches_from;
    return json;
}

std::string found_chains_text(const Upload& upload) {
    Json branchings = Json::array(), head;
    for (const int node : upload.found.branchings) branchings.push_back(named_node_json(upload, node));
    if (upload.found.head >= 0) {
        head = named_node_json(upload, upload.found.head);
        head["center"] = pose_json(upload.found.head_center);
    }
    const Json before{{"facing", upload.character.faces_minus_z ? "-Z" : "+Z"}, {"head", std::move(head)}};
    const Json after{{"branchings", std::move(branchings)}, {"skipped", skipped_json(upload)}};
    std::string text = before.dump();
    text.pop_back();
    text += ",\"chains\":[";
    for (std::size_t i = 0; i < upload.found.chains.size(); ++i) {
        if (i > 0) text += ',';
        text += found_chain_json(upload, i).dump();
    }
    text.append("],").append(after.dump(), 1);
    return text;
}

std::vector<ChainPoses> character_poses(const Upload& upload, std::span<const FoundChain> moved,
                                        std::span<const Chain> chains, const HairMotion& motion,
                                        const std::stop_token& stop) {
    Poses poses = all_poses(upload, moved, chains, motion);
    std::vector<ChainPoses> made(moved.size());
    for (std::size_t c = 0; c < moved.size() && !stop.stop_requested(); ++c) {
        const std::vector<Pose> own = std::move(poses[c]);
        const std::size_t nodes = chains[c].nodes.size();
        made[c] = {chains[c].name, nodes, {}};
        made[c].poses.reserve(own.size() * nodes);
        for (std::size_t n = 0; n < own.size(); ++n) {
            for (std::size_t i = 0; i < nodes; ++i) {
                const Quat& rotation = motion.chains[c].rotations[n * nodes + i];
                const bool is_tip = i + 1 == nodes;
                made[c].poses.push_back(
                    node_pose(is_tip ? rotation : character::to_node_rotation(upload.character, moved[c], i, rotation),
                              own[n].turns[i], own[n].positions[i]));
            }
        }
    }
    return made;
}

}  // namespace tuftwave::server
