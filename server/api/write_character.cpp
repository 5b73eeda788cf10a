#include "api/write_character.hpp"

#include <nlohmann/json.hpp>
#include <string>

#include "api/choices.hpp"
#include "api/write_nouns.hpp"

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

Json found_chains_json(const Upload& upload) {
    Json chains = Json::array(), branchings = Json::array(), head;
    for (std::size_t i = 0; i < upload.found.chains.size(); ++i) chains.push_back(found_chain_json(upload, i));
    for (const int node : upload.found.branchings) branchings.push_back(named_node_json(upload, node));
    if (upload.found.head >= 0) {
        head = named_node_json(upload, upload.found.head);
        head["center"] = pose_json(upload.found.head_center);
    }
    return {{"facing", upload.character.faces_minus_z ? "-Z" : "+Z"},
            {"head", std::move(head)},
            {"chains", std::move(chains)},
            {"branchings", std::move(branchings)},
            {"skipped", skipped_json(upload)}};
}

Json character_pictures_json(const Upload& upload, std::span<const std::size_t> chosen, std::span<const Chain> chains,
                             const HairMotion& motion, const std::stop_token& stop) {
    Json pictures = pictures_json(chains, motion, stop);
    for (std::size_t n = 0; n < pictures.size(); ++n) {
        for (std::size_t c = 0; c < chosen.size(); ++c) {
            const FoundChain& chain = upload.found.chains[chosen[c]];
            const std::size_t first = n * chains[c].nodes.size();
            Json& rotations = pictures[n]["chains"][c]["rotations"];
            for (std::size_t i = 0; i < chain.bones.size(); ++i) {
                const Quat& rotation = motion.chains[c].rotations[first + i];
                rotations[i] = pose_json(character::to_node_rotation(upload.character, chain, i, rotation));
            }
        }
    }
    return pictures;
}

}  // namespace tuftwave::server
