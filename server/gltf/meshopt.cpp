#include "gltf/meshopt.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <vector>

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

using Indices = std::span<const std::uint32_t>;

std::size_t encode(Indices indices, std::span<char> to) {
    return meshopt_encodeIndexBuffer(raw(to), to.size(), indices.data(), indices.size());
}

/// The fewest triangles and vertices of a part that is looked for: two such leave nothing of the codec's beginning,
/// which remembers 16 edges and 16 vertices.
constexpr std::size_t kLeastTriangles = 16, kLeastVertices = 8, kLeastParts = 4;

/// How many indices are a part that is all there is, each time with vertices beyond those before; 0 if there is none.
std::size_t part_of(Indices indices) {
    std::uint32_t least = indices[0], most = indices[0];
    std::size_t part = 0;
    for (; part < indices.size(); part += 3) {
        const auto [low, high] = std::minmax({indices[part], indices[part + 1], indices[part + 2]});
        if (part > 0 && low > most) break;
        least = std::min(least, low);
        most = std::max(most, high);
    }
    if (part < 3 * kLeastTriangles || indices.size() % part != 0 || indices.size() / part < kLeastParts) return 0;
    const std::uint32_t vertices = indices[part] - indices[0];
    if (vertices < kLeastVertices || least + vertices <= most) return 0;
    std::uint32_t others = 0;  // not left at the first one, so that it is vectors
    for (std::size_t i = part; i < indices.size(); ++i) others |= indices[i] ^ (indices[i - part] + vertices);
    return others == 0 ? part : 0;
}

/// The format is a byte, one for each triangle, what these leave to be said, and a table at the end. All is told by how
/// far it is from what was before, so that from the third part on the same bytes come again.
/// @param part  as part_of() has it
std::size_t encode_parts(Indices indices, std::size_t part, std::span<char> to) {
    constexpr std::size_t kHead = 1, kTable = 16;
    const std::size_t more = indices.size() / part - 3, triangles = part / 3;
    std::vector<char> two(most_for_triangles(2 * part, indices.size())),
        three(most_for_triangles(3 * part, indices.size()));
    const std::size_t two_bytes = encode(indices.first(2 * part), two), bytes = encode(indices.first(3 * part), three);
    const std::size_t rest_two = two_bytes - kHead - 2 * triangles - kTable;
    const std::size_t rest = bytes - kHead - 3 * triangles - kTable;
    char* out = to.data();
    const auto put = [&](std::size_t first, std::size_t count) { out = std::copy_n(three.data() + first, count, out); };
    put(0, kHead + 3 * triangles);
    for (std::size_t i = 0; i < more; ++i) put(kHead + 2 * triangles, triangles);
    put(kHead + 3 * triangles, rest);
    for (std::size_t i = 0; i < more; ++i) put(kHead + 3 * triangles + rest_two, rest - rest_two);
    put(bytes - kTable, kTable);
    return static_cast<std::size_t>(out - to.data());
}

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
    const std::size_t part = part_of(indices);
    return part > 0 ? encode_parts(indices, part, to) : encode(indices, to);
}

}  // namespace tuftwave::server::gltf
