#include "gltf/hair_file.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "gltf/flip_book.hpp"
#include "gltf/hair_meshes.hpp"
#include "gltf/names.hpp"
#include "gltf/packed_file.hpp"
#include "gltf/skeleton_nodes.hpp"
#include "tuftwave/elementary.hpp"
#include "version.hpp"

namespace tuftwave::server::gltf {
namespace {

const std::string kGenerator = std::string("Tuftwave ") + kVersion;

/// All values of a colour channel from sRGB to linear.
std::array<double, 256> linear_channels() {
    std::array<double, 256> channels;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const double value = static_cast<double>(i) / 255;
        channels[i] = value <= 0.04045 ? value / 12.92 : elementary::pow((value + 0.055) / 1.055, 2.4);
    }
    return channels;
}

/// @param digits  two hexadecimal digits
double linear_channel(const std::string& digits) {
    static const std::array<double, 256> channels = linear_channels();
    return channels[static_cast<std::size_t>(std::stoi(digits, nullptr, 16))];
}

std::array<double, 3> linear_color(const std::string& color) {
    return {linear_channel(color.substr(1, 2)), linear_channel(color.substr(3, 2)), linear_channel(color.substr(5, 2))};
}

File flip_book_file(const HairPlan& plan, const Look& look, std::string asset_extras, const Clip& clip,
                    Container container, const ForEach& for_each, const std::stop_token& stop) {
    Document document(kGenerator);
    document.set_asset_extras(std::move(asset_extras));
    const int material = document.add_material("hair", linear_color(look.color));
    FlipBook book(document, plan, clip_keys(plan.motion->schedule, clip.holding), material, clip.extras);
    document.allocate(container);
    book.fill(for_each, stop);
    return document.write(container);
}

}  // namespace

File hair_file(const HairPlan& plan, const Look& look, std::string asset_extras, const Clip& clip, Container container,
               Compression compression, const ForEach& for_each, const std::stop_token& stop) {
    if (plan.motion && clip.kind == ClipKind::kFlipBook)
        return flip_book_file(plan, look, std::move(asset_extras), clip, container, for_each, stop);
    Document document(kGenerator);
    document.set_asset_extras(std::move(asset_extras));
    const bool has_skin = plan.hairstyle->mesh.skin, is_merged = look.layout == Layout::kMerged;
    std::vector<std::string> names;
    if (has_skin || !is_merged) names = claim_names(plan.chains, "tuft");
    std::optional<SkeletonNodes> skeleton;
    if (has_skin) skeleton.emplace(document, plan.chains, names);
    HairMeshes meshes(document, plan, compression == Compression::kMeshopt);
    const int material = document.add_material("hair", linear_color(look.color));
    if (is_merged) {
        meshes.reserve_merged(skeleton ? &*skeleton : nullptr, material);
    } else {
        meshes.reserve_per_tuft(names, skeleton ? &*skeleton : nullptr, material);
    }
    std::optional<HeldClip> keys;
    if (plan.motion) keys.emplace(document, *skeleton, clip_keys(plan.motion->schedule, clip.holding), clip.extras);

    document.allocate(container);
    meshes.fill(for_each, stop);
    if (keys) keys->fill(plan.motion->chains);
    if (compression == Compression::kMeshopt) return packed_file(document, for_each, stop);
    return document.write(container);
}

File clip_file(std::span<const Chain> chains, const HairMotion& motion, std::string asset_extras, const Clip& clip,
               Container container) {
    Document document(kGenerator);
    document.set_asset_extras(std::move(asset_extras));
    const SkeletonNodes skeleton(document, chains, claim_names(chains, "chain"));
    HeldClip keys(document, skeleton, clip_keys(motion.schedule, clip.holding), clip.extras);
    document.allocate(container);
    keys.fill(motion.chains);
    return document.write(container);
}

}  // namespace tuftwave::server::gltf
