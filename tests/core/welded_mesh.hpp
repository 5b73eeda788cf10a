#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "tuftwave/tuft.hpp"

/// Whether a mesh is closed. The columns of a tuft that meet at its seam are two vertices at the same place.
namespace tuftwave::test {

/// A mesh whose vertices at the same place count as one. Triangles that have lost their area by that are left out.
struct Welded {
    std::size_t vertices = 0, triangles = 0, collapsed = 0;
    std::vector<std::array<std::size_t, 2>> edges;  ///< directed, sorted
};

inline Welded welded(const Mesh& mesh) {
    const std::size_t count = mesh.positions.size() / 3;
    const auto place = [&](const std::size_t i) {
        return std::array{mesh.positions[3 * i], mesh.positions[3 * i + 1], mesh.positions[3 * i + 2]};
    };
    std::vector<std::size_t> order(count), same(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](const std::size_t a, const std::size_t b) { return place(a) < place(b); });
    Welded result;
    for (std::size_t i = 0; i < count; ++i) {
        const bool first = i == 0 || place(order[i]) != place(order[i - 1]);
        same[order[i]] = first ? order[i] : same[order[i - 1]];
        result.vertices += first ? 1 : 0;
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::size_t a = same[mesh.indices[i]], b = same[mesh.indices[i + 1]], c = same[mesh.indices[i + 2]];
        if (a == b || b == c || c == a) {
            ++result.collapsed;
            continue;
        }
        ++result.triangles;
        result.edges.insert(result.edges.end(), {{a, b}, {b, c}, {c, a}});
    }
    std::sort(result.edges.begin(), result.edges.end());
    return result;
}

/// Whether every edge is met as often in one direction as in the other.
inline testing::AssertionResult is_closed(const Welded& mesh) {
    auto reversed = mesh.edges;
    for (auto& edge : reversed) std::swap(edge[0], edge[1]);
    std::sort(reversed.begin(), reversed.end());
    const auto [a, b] = std::mismatch(mesh.edges.begin(), mesh.edges.end(), reversed.begin());
    if (a == mesh.edges.end()) return testing::AssertionSuccess();
    const auto& edge = std::min(*a, *b);
    return testing::AssertionFailure() << "edge " << edge[0] << "-" << edge[1] << " has no partner";
}

/// Whether the mesh is closed, every edge belongs to just two triangles, and there are no handles: V - E + F = 2.
inline testing::AssertionResult is_sphere(const Welded& mesh) {
    if (mesh.collapsed != 0) return testing::AssertionFailure() << mesh.collapsed << " triangles have no area";
    if (testing::AssertionResult closed = is_closed(mesh); !closed) return closed;
    const auto twice = std::adjacent_find(mesh.edges.begin(), mesh.edges.end());
    if (twice != mesh.edges.end())
        return testing::AssertionFailure() << "edge " << (*twice)[0] << "-" << (*twice)[1] << " is met twice";
    const auto euler = static_cast<long>(mesh.vertices + mesh.triangles) - static_cast<long>(mesh.edges.size() / 2);
    if (euler == 2) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "V - E + F is " << euler;
}

}  // namespace tuftwave::test
