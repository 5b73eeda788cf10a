#pragma once

#include <cstddef>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "gltf/model.hpp"
#include "tuftwave/for_each.hpp"

namespace tuftwave::server::gltf {

/// What a document's views hold now.
struct Quantized {
    std::string memory;                             ///< of the vertices, from memory::take_buffer()
    std::vector<std::span<const std::byte>> views;  ///< of the vertices in `memory`, of all else where it was
};

/// Makes a filled document's vertices whole numbers, as KHR_mesh_quantization allows, and says so in its views,
/// accessors, bounds and nodes. The offsets of views no longer mean anything.
/// @param model  of hair: each mesh has vertices of its own and one node, a root of its name that nothing turns
///
/// A mesh's positions are counted in a cube around it. Its node carries them back or, where it has a skin, since a skin
/// takes no notice of its node, the inverse bind matrices do. Deterministic for any `for_each`; incomplete once `stop`
/// is set.
Quantized quantize(Document::Model& model, const ForEach& for_each, const std::stop_token& stop);

}  // namespace tuftwave::server::gltf
