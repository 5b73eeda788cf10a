#pragma once

#include <cstddef>

namespace tuftwave::server::gltf {

/// Whether 16 bits are enough to name every vertex. The largest index is a GPU's restart mark and must not occur.
inline bool fits_short(std::size_t vertices) { return vertices <= 65'535; }

}  // namespace tuftwave::server::gltf
