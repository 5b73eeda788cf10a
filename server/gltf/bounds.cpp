#include "gltf/bounds.hpp"

#include <algorithm>
#include <cstddef>

#include "tuftwave/wide.hpp"

namespace tuftwave::server::gltf {
namespace {

/// Numbers that are looked at side by side: whole points, and whole vectors.
constexpr std::size_t kSide = 24;

using Sides = std::array<float, kSide>;

/// @param points  kSide numbers at least
TUFTWAVE_BODY void look(std::span<const float> points, Sides& least_found, Sides& most_found) {
    Sides least = least_found, most = most_found;  // stay in registers, since no point can be among them
    const std::size_t last = points.size() - kSide;
    for (std::size_t next = 0; next < points.size(); next += kSide) {
        const std::size_t at = next < last ? next : last;  // some at the end are looked at twice
        for (std::size_t k = 0; k < kSide; ++k) {
            const float value = points[at + k];
            least[k] = value < least[k] ? value : least[k];
            most[k] = value > most[k] ? value : most[k];
        }
    }
    least_found = least;
    most_found = most;
}

}  // namespace

void Bounds::include(const Bounds& other) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        least[axis] = std::min(least[axis], other.least[axis]);
        most[axis] = std::max(most[axis], other.most[axis]);
    }
}

Bounds bounds_of(std::span<const float> points) {
    Sides least, most;
    for (std::size_t k = 0; k < kSide; ++k) least[k] = most[k] = points[k % std::min(points.size(), kSide)];
    if (points.size() > kSide) run_with<look>(widest_vectors(), points, least, most);
    Bounds bounds{{least[0], least[1], least[2]}, {most[0], most[1], most[2]}};
    for (std::size_t k = 3; k < kSide; k += 3)
        bounds.include({{least[k], least[k + 1], least[k + 2]}, {most[k], most[k + 1], most[k + 2]}});
    for (auto* const box : {&bounds.least, &bounds.most}) {
        for (float& value : *box) value += 0.0F;  // which of two zeros was met first is no matter
    }
    return bounds;
}

}  // namespace tuftwave::server::gltf
