#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tuftwave/math.hpp"

namespace tuftwave {

/// Triangles ordered for rays from the origin and for the way to a surface: a binary tree of boxes.
class TriangleTree {
  public:
    /// @param triangles  corners, in a space whose origin is where the rays start; at least one
    /// Cost O(n log n) time, O(n) memory. Deterministic.
    explicit TriangleTree(std::vector<std::array<Vec3, 3>> triangles);

    /// How far the triangles are that a ray meets, in rising order. Two triangles with a common edge leave no gap
    /// between them, and are met once where the ray goes through it.
    /// @param direction  unit
    /// Cost about O(log n) for each that is met.
    std::vector<double> hits(const Vec3& direction) const;

    /// The place on the triangles that is nearest to a point.
    /// Cost about O(log n).
    Vec3 nearest(const Vec3& point) const;

  private:
    struct Box {
        Vec3 low, high;
    };
    struct Node {
        Box box;
        std::uint32_t first, count;  // leaf: triangles; else count is 0 and the children are at this + 1 and at `first`
    };

    Vec3 nearest_below(std::uint32_t node, const Vec3& point, const Vec3& best) const;
    void build(std::uint32_t first, std::uint32_t count);
    Box box_around(std::uint32_t first, std::uint32_t count) const;

    std::vector<std::array<Vec3, 3>> triangles_;
    std::vector<Node> nodes_;
};

}  // namespace tuftwave
