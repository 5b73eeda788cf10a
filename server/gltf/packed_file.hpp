#pragma once

#include <stop_token>

#include "gltf/document.hpp"
#include "tuftwave/for_each.hpp"

namespace tuftwave::server::gltf {

/// Writes a filled document as a GLB of a quarter to a third of the bytes, for readers that know KHR_mesh_quantization
/// and EXT_meshopt_compression. The document is used up.
/// @param document  of hair, as quantize() has it; allocated as a GLB
///
/// Whole views are packed, each by one worker; what would not get shorter stays as it is. Deterministic for any
/// `for_each`; incomplete once `stop` is set.
File packed_file(Document& document, const ForEach& for_each, const std::stop_token& stop);

}  // namespace tuftwave::server::gltf
