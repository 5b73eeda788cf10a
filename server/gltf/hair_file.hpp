#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <stop_token>
#include <string>

#include "gltf/clip_keys.hpp"
#include "gltf/document.hpp"
#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server::gltf {

/// One mesh per tuft, each with a skin of its own, or all tufts in one mesh.
enum class Layout { kPerTuft, kMerged };

/// What a hair file looks like besides its geometry.
struct Look {
    Layout layout = Layout::kPerTuft;
    std::string color = "#8a5a44";  ///< sRGB, # and six hexadecimal digits
};

/// What a file's clip is like.
struct Clip {
    const nlohmann::json& extras;  ///< goes into the clip's extras
    Holding holding = Holding::kStep;
    ClipKind kind = ClipKind::kSkeleton;
};

/// How a file's bytes are packed.
enum class Compression { kNone, kMeshopt };

/// Writes a planned hairstyle: meshes, skeleton, weights and, if it moves, its clip; or, if it moves and is to be a
/// flip book, a mesh per picture, in which all tufts are one.
/// @param asset_extras  text of an object, as extras_text() writes it; goes into asset.extras
/// @param clip          ignored when nothing moves
/// @param compression   kNone for flip books and but for GLB
/// Deterministic for any `for_each`; incomplete once `stop` is set.
File hair_file(const HairPlan& plan, const Look& look, std::string asset_extras, const Clip& clip, Container container,
               Compression compression, const ForEach& for_each, const std::stop_token& stop);

/// Writes a skeleton and its clip, without meshes.
File clip_file(std::span<const Chain> chains, const HairMotion& motion, std::string asset_extras, const Clip& clip,
               Container container);

}  // namespace tuftwave::server::gltf
