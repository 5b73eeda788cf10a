#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

/// The codecs of EXT_meshopt_compression, which lose nothing. The same bytes always; thread-safe.
namespace tuftwave::server::gltf {

/// Bytes that so many elements take at most. @param stride  bytes of each, a multiple of 4, at most 256
std::size_t most_for_attributes(std::size_t count, std::size_t stride);

/// @param elements  one or more
/// @param to        with room for the most
/// @return          bytes that it took
std::size_t encode_attributes(std::span<const std::byte> elements, std::size_t stride, std::span<char> to);

/// Bytes that so many indices take at most. @param vertices  more than the largest of them
std::size_t most_for_triangles(std::size_t count, std::size_t vertices);

/// The library's own bytes, sooner where the same part comes again and again with vertices of its own, as tufts of one
/// shape do.
/// @param indices  of one triangle or more, three each
/// @param to       with room for the most
/// @return         bytes that it took
std::size_t encode_triangles(std::span<const std::uint32_t> indices, std::span<char> to);

}  // namespace tuftwave::server::gltf
