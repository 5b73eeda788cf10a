#include "gltf/meshopt.hpp"

#include <meshoptimizer.h>

namespace tuftwave::server::gltf {
namespace {

/// Newer releases of the library know other formats, which the extension does not. They are chosen for the whole
/// process.
void choose_formats() {
    static const bool is_chosen = [] {
        meshopt_encodeVertexVersion(0);
        meshopt_encodeIndexVersion(1);
        return true;
    }();
    static_cast<void>(is_chosen);
}

unsigned char* raw(std::span<char> bytes) { return reinterpret_cast<unsigned char*>(bytes.data()); }

}  // namespace

std::size_t most_for_attributes(std::size_t count, std::size_t stride) {
    choose_formats();
    return meshopt_encodeVertexBufferBound(count, stride);
}

std::size_t encode_attributes(std::span<const std::byte> elements, std::size_t stride, std::span<char> to) {
    choose_formats();
    return meshopt_encodeVertexBuffer(raw(to), to.size(), elements.data(), elements.size() / stride, stride);
}

std::size_t most_for_triangles(std::size_t count, std::size_t vertices) {
    choose_formats();
    return meshopt_encodeIndexBufferBound(count, vertices);
}

std::size_t encode_triangles(std::span<const std::uint32_t> indices, std::span<char> to) {
    choose_formats();
    return meshopt_encodeIndexBuffer(raw(to), to.size(), indices.data(), indices.size());
}

}  // namespace tuftwave::server::gltf
