#pragma once

#include <cstdint>
#include <span>

namespace tuftwave::server::gltf {

/// Puts a tuft's triangles into the order in which meshoptimizer's codec has a byte for each instead of two.
/// @param triangles  as write_indices() writes them
///
/// The codec says nothing more of a vertex that is the next one that it has not met, or the one beside what it said
/// last. The fan at the root goes around against the order of its vertices, so that behind its first triangle the next
/// one is never met again. Hence all of it but the last triangle goes to the end, before the last one at the tip: that
/// one meets the tip, which by then is forgotten, as the next. With few sides the codec remembers a whole ring, and
/// nothing is changed.
void order_for_packing(std::span<std::uint16_t> triangles, int sides);
void order_for_packing(std::span<std::uint32_t> triangles, int sides);

}  // namespace tuftwave::server::gltf
