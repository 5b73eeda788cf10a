#pragma once

#include <span>
#include <string>
#include <vector>

#include "gltf/clip_keys.hpp"
#include "gltf/document.hpp"
#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server::gltf {

/// The nodes of one chain: a joint per bone, and the tip, which is no joint.
struct ChainNodes {
    std::vector<int> joints;
    int tip = 0;
};

/// Adds chains under one plain root node, in the scene.
class SkeletonNodes {
  public:
    SkeletonNodes(Document& document, std::span<const Chain> chains, const std::vector<std::string>& names);

    int root() const { return root_; }
    const std::vector<ChainNodes>& chains() const { return chains_; }

  private:
    void add_chain(const Chain& chain, const std::string& name);

    Document& document_;
    int root_;
    std::vector<ChainNodes> chains_;
};

/// A clip that keeps each picture on show until the next, over the nodes of a skeleton.
class HeldClip {
  public:
    /// Reserves room for the keys.
    HeldClip(Document& document, const SkeletonNodes& skeleton, ClipKeys keys, const nlohmann::json& extras);

    /// Writes the keys; call after document.allocate().
    void fill(std::span<const ChainMotion> motions);

  private:
    struct Tracks {
        int first;  ///< accessor of the first joint's keys, behind which are those of the others
        std::size_t joints;
    };

    Document& document_;
    const ClipKeys keys_;
    int times_ = 0;
    std::vector<Tracks> tracks_;  // of the chains
};

}  // namespace tuftwave::server::gltf
