#include "tuftwave/triangle_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "scalp_shapes.hpp"
#include "support.hpp"

namespace tuftwave {
namespace {

using Triangles = std::vector<std::array<Vec3, 3>>;

Triangles triangles_of(const ScalpMesh& mesh) {
    Triangles triangles;
    for (const auto& [a, b, c] : mesh.triangles)
        triangles.push_back({mesh.positions[a], mesh.positions[b], mesh.positions[c]});
    return triangles;
}

/// By plane and inside test, each triangle by itself: slow, and another way than the tree's.
double last_hit_by_hand(const Triangles& triangles, const Vec3& direction) {
    double farthest = -1;
    for (const auto& [a, b, c] : triangles) {
        const Vec3 normal = cross(b - a, c - a);
        const double along = dot(normal, direction);
        if (along == 0) continue;
        const double distance = dot(normal, a) / along;
        const Vec3 at = distance * direction;
        const bool is_inside = dot(cross(b - a, at - a), normal) >= 0 && dot(cross(c - b, at - b), normal) >= 0 &&
                               dot(cross(a - c, at - c), normal) >= 0;
        if (is_inside && distance >= 0) farthest = std::max(farthest, distance);
    }
    return farthest;
}

TEST(TriangleTree, FindsWhatEachTriangleByItselfFinds) {
    test::Random random(1);
    Triangles soup;
    for (int i = 0; i < 500; ++i) {
        const Vec3 middle = random.in_cube(1);
        soup.push_back({middle + random.in_cube(0.2), middle + random.in_cube(0.2), middle + random.in_cube(0.2)});
    }
    const TriangleTree tree(soup);
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 direction = random.direction();
        const double expected = last_hit_by_hand(soup, direction);
        const std::vector<double> hits = tree.hits(direction);
        EXPECT_NEAR(hits.empty() ? -1 : hits.back(), expected, 1e-9);
        met += expected >= 0;
    }
    EXPECT_GT(met, 1000);
    EXPECT_LT(met, 2000);  // some rays miss, so that missing is tried, too
}

TEST(TriangleTree, LeavesNoGapAtEdgesAndCorners) {
    const ScalpMesh sphere = test::sphere_mesh({}, 1, 12);
    const TriangleTree tree(triangles_of(sphere));
    for (const auto& triangle : sphere.triangles) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Vec3& a = sphere.positions[triangle[corner]];
            const Vec3& b = sphere.positions[triangle[(corner + 1) % 3]];
            EXPECT_EQ(tree.hits(normalized(a)).size(), 1u);
            for (const double part : {0.1, 0.5, 1.0 / 3})
                EXPECT_EQ(tree.hits(normalized(a + part * (b - a))).size(), 1u);
        }
    }
}

TEST(TriangleTree, GivesAllInRisingOrder) {
    Triangles walls;
    for (const double distance : {1.0, 3.0, 2.0})
        walls.push_back({Vec3{distance, -5, -5}, Vec3{distance, 5, -5}, Vec3{distance, 0, 5}});
    const TriangleTree tree(walls);
    EXPECT_EQ(tree.hits({1, 0, 0}), (std::vector<double>{1, 2, 3}));
    EXPECT_TRUE(tree.hits({-1, 0, 0}).empty());  // behind
}

TEST(TriangleTree, TrianglesWithoutAreaAreNeverInTheWay) {
    const TriangleTree tree(
        {{Vec3{1, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 0, 0}}, {Vec3{1, 1, 0}, Vec3{1, -1, 0}, Vec3{1, 0, 0}}});
    EXPECT_TRUE(tree.hits({0, 0, 1}).empty());
    for (const double distance : tree.hits({1, 0, 0})) EXPECT_TRUE(std::isfinite(distance));
}

TEST(TriangleTree, FindsTheNearestPlace) {
    const ScalpMesh sphere = test::sphere_mesh({0.1, 0, 0}, 1, 24);
    const TriangleTree tree(triangles_of(sphere));
    test::Random random(3);
    for (int i = 0; i < 500; ++i) {
        const Vec3 direction = random.direction();
        const Vec3 point = Vec3{0.1, 0, 0} + random.between(0.2, 3) * direction;
        // Facets lie up to 1 - cos(pi / 24) = 0.0086 below the sphere.
        EXPECT_TRUE(test::are_near(tree.nearest(point), Vec3{0.1, 0, 0} + direction, 0.15));
        EXPECT_NEAR(length(tree.nearest(point) - point), std::abs(length(point - Vec3{0.1, 0, 0}) - 1), 0.009);
    }
}

TEST(TriangleTree, TheNearestPlaceMayBeACornerAnEdgeOrAFace) {
    const TriangleTree tree({{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}});
    EXPECT_EQ(tree.nearest({-1, -1, 2}), (Vec3{0, 0, 0}));
    EXPECT_EQ(tree.nearest({0.5, -1, 1}), (Vec3{0.5, 0, 0}));
    EXPECT_EQ(tree.nearest({0.25, 0.25, -3}), (Vec3{0.25, 0.25, 0}));
}

}  // namespace
}  // namespace tuftwave
