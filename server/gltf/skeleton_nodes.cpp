#include "gltf/skeleton_nodes.hpp"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "gltf/names.hpp"

namespace tuftwave::server::gltf {
namespace {

/// Through float32, which is what glTF's readers keep, and so with half the digits.
double as_float(double value) {
    const volatile float rounded = static_cast<float>(value);  // g++ 12 vectorizes the rounding away
    return static_cast<double>(rounded);
}

std::array<double, 3> to_array(const Vec3& v) { return {as_float(v.x), as_float(v.y), as_float(v.z)}; }
std::array<double, 4> to_array(const Quat& q) { return {as_float(q.x), as_float(q.y), as_float(q.z), as_float(q.w)}; }

/// @param out  x y z w; whole, so that the conversions become one
void write_key(const Quat& q, float* out) {
    const std::array<float, 4> key{static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z),
                                   static_cast<float>(q.w)};
    std::memcpy(out, key.data(), sizeof key);
}

}  // namespace

SkeletonNodes::SkeletonNodes(Document& document, std::span<const Chain> chains, const std::vector<std::string>& names)
    : document_(document), root_(document.add_node({"hair_root", {}, {}, {}, {}})) {
    document_.add_to_scene(root_);
    std::size_t nodes = 0;
    for (const Chain& chain : chains) nodes += chain.nodes.size() + 1;
    document_.expect(nodes, 0);
    chains_.reserve(chains.size());
    for (std::size_t i = 0; i < chains.size(); ++i) add_chain(chains[i], names[i]);
}

void SkeletonNodes::add_chain(const Chain& chain, const std::string& name) {
    ChainNodes nodes;
    nodes.joints.reserve(chain.nodes.size() - 1);
    int parent = root_;
    Quat global;
    Vec3 origin;
    if (!(chain.parent_rotation == Quat{})) {
        global = normalized(chain.parent_rotation);
        parent = document_.add_node({Names::joint(name, 0), {}, to_array(global), {}, {}}, root_);
    }
    for (std::size_t i = 0; i < chain.nodes.size(); ++i) {
        const Vec3 translation = rotated(inverse(global), chain.nodes[i] - origin);
        const Quat rotation = normalized(chain.rest_rotations[i]);
        const int node =
            document_.add_node({Names::joint(name, i + 1), to_array(translation), to_array(rotation), {}, {}}, parent);
        if (i + 1 < chain.nodes.size()) nodes.joints.push_back(node);
        parent = node;
        global = global * rotation;
        origin = chain.nodes[i];
    }
    if (chain.name != name && !chain.name.empty())
        document_.set_node_extras(nodes.joints.front(), {{"name", chain.name}});
    nodes.tip = parent;
    chains_.push_back(std::move(nodes));
}

HeldClip::HeldClip(Document& document, const SkeletonNodes& skeleton, ClipKeys keys, const nlohmann::json& extras)
    : document_(document), keys_(std::move(keys)) {
    const std::size_t count = keys_.times.size(), bytes = count * 4 * sizeof(float);
    std::size_t joints = 0;
    for (const ChainNodes& chain : skeleton.chains()) joints += chain.joints.size();
    document.expect(0, joints + 1);
    times_ = document.add_accessor({document.add_view(Document::Purpose::kData, count * sizeof(float)), 0, count,
                                    Document::Component::kF32, Document::Shape::kScalar, true});
    const int view = document.add_view(Document::Purpose::kData, joints * bytes);
    std::vector<Document::Channel> channels;
    channels.reserve(joints);
    tracks_.reserve(skeleton.chains().size());
    for (const ChainNodes& chain : skeleton.chains()) {
        for (const int node : chain.joints) {
            const int values = document.add_accessor(
                {view, channels.size() * bytes, count, Document::Component::kF32, Document::Shape::kVec4});
            channels.push_back({node, values});
        }
        tracks_.push_back({channels[channels.size() - chain.joints.size()].values, chain.joints.size()});
    }
    const auto between = keys_.is_stepped ? Document::Interpolation::kStep : Document::Interpolation::kLinear;
    document.add_animation("wave", times_, between, std::move(channels), extras);
}

void HeldClip::fill(std::span<const ChainMotion> motions) {
    std::ranges::copy(keys_.times, document_.data<float>(times_).begin());
    document_.set_bounds(times_);
    for (std::size_t c = 0; c < tracks_.size(); ++c) {
        const std::size_t joints = tracks_[c].joints, count = keys_.pictures.size();
        float* const out = document_.data<float>(tracks_[c].first).data();
        for (std::size_t key = 0; key < count; ++key) {
            const Quat* const pose = &motions[c].rotations[keys_.pictures[key] * (joints + 1)];
            for (std::size_t i = 0; i < joints; ++i) write_key(pose[i], out + 4 * (i * count + key));
        }
    }
}

}  // namespace tuftwave::server::gltf
