// Based on: linear blend skinning as glTF 2.0 defines it, with bones as rigid motions in place of matrices.
#include "tuftwave/skinning.hpp"

#include <cstddef>
#include <vector>

#include "tuftwave/motion.hpp"
#include "tuftwave/vector_checks.hpp"

namespace tuftwave {
namespace {

Vec3 vector_at(std::span<const float> numbers, std::size_t vertex) {
    const auto part = [&](std::size_t axis) { return static_cast<double>(numbers[3 * vertex + axis]); };
    return {part(0), part(1), part(2)};
}

void put(std::span<float> numbers, std::size_t vertex, const Vec3& v) {
    numbers[3 * vertex] = static_cast<float>(v.x);
    numbers[3 * vertex + 1] = static_cast<float>(v.y);
    numbers[3 * vertex + 2] = static_cast<float>(v.z);
}

}  // namespace

void write_posed_vertices(const Mesh& rest, const Chain& chain, std::span<const Quat> rotations,
                          std::span<float> positions, std::span<float> normals) {
    const std::vector<Quat> turns = model_turns(chain, rotations);
    const std::vector<Vec3> places = node_positions(chain, rotations);
    for (std::size_t vertex = 0; vertex < rest.positions.size() / 3; ++vertex) {
        const Vec3 position = vector_at(rest.positions, vertex), normal = vector_at(rest.normals, vertex);
        Vec3 place, direction;
        for (std::size_t k = 4 * vertex; k < 4 * vertex + 4; ++k) {
            const auto weight = static_cast<double>(rest.weights[k]);
            if (weight == 0) continue;
            const std::size_t bone = rest.joints[k];
            place = place + weight * (places[bone] + rotated(turns[bone], position - chain.nodes[bone]));
            direction = direction + weight * rotated(turns[bone], normal);
        }
        // Two bones that are turned against each other leave no direction; then the first one's will do.
        const bool has_direction = length(direction) > kSmallestSine;
        put(positions, vertex, place);
        put(normals, vertex,
            has_direction ? normalized(direction) : rotated(turns[rest.joints[4 * vertex]], normalized(normal)));
    }
}

}  // namespace tuftwave
