#include "tuftwave/scalp.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "scalp_shapes.hpp"
#include "support.hpp"

namespace tuftwave {
namespace {

using test::are_near;

Head head_with(const ScalpShape& shape) {
    Head head;
    head.center = {0.5, 1.5, -0.2};
    head.scalp = shape;
    return head;
}

Scalp scalp_of(const Head& head) { return *Scalp::of(head); }

TEST(Scalp, OfAHeadWithoutOneIsNone) { EXPECT_FALSE(Scalp::of(Head{})); }

TEST(Scalp, AnEllipsoidHasItsRadiiAlongTheHeadsAxes) {
    const Scalp scalp = scalp_of(head_with(ScalpEllipsoid{{}, {0.08, 0.12, 0.1}}));  // width, height, depth
    EXPECT_DOUBLE_EQ(*scalp.distance_towards({1, 0, 0}), 0.08);                      // left
    EXPECT_DOUBLE_EQ(*scalp.distance_towards({0, -1, 0}), 0.1);                      // front
    EXPECT_DOUBLE_EQ(*scalp.distance_towards({0, 0, 1}), 0.12);                      // up
}

TEST(Scalp, EveryDirectionMeetsAnEllipsoidOnItsSurface) {
    const Vec3 middle{0.51, 1.53, -0.22}, radii{0.08, 0.12, 0.1};
    const Head head = head_with(ScalpEllipsoid{middle, radii});
    const Scalp scalp = scalp_of(head);
    const HeadFrame frame(head);
    test::Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 direction = random.direction();
        const Vec3 at = frame.to_model(*scalp.distance_towards(direction) * direction) - middle;
        EXPECT_NEAR(length({at.x / radii.x, at.y / radii.y, at.z / radii.z}), 1, 1e-14);
    }
}

TEST(Scalp, AFineMeshOfASphereIsNearlyTheSphere) {
    const Head head = head_with(test::sphere_mesh({0.5, 1.5, -0.2}, 0.1, 64));
    const Scalp scalp = scalp_of(head);
    // A facet sags by the radius times 1 - cos of half its angle, less than 0.1 (1 - cos(2 pi / 128)).
    test::Random random(2);
    for (int i = 0; i < 1000; ++i) EXPECT_NEAR(*scalp.distance_towards(random.direction()), 0.1, 1.3e-4);
}

TEST(Scalp, AMeshTurnsWithTheHead) {
    Head head = head_with(test::sphere_mesh({0.5, 1.5, -0.2}, 0.1, 8));
    const Scalp upright = scalp_of(head);
    head.up = {1, 0, 0};
    const Scalp lying = scalp_of(head);  // its up is the mesh's left
    EXPECT_DOUBLE_EQ(*lying.distance_towards({0, 0, 1}), *upright.distance_towards({1, 0, 0}));
}

TEST(Scalp, WhereAMeshHasNoSurfaceThereIsNoScalp) {
    ScalpMesh cap;
    cap.positions = {{0.4, 1.6, -0.3}, {0.6, 1.6, -0.3}, {0.5, 1.6, 0}};
    cap.triangles = {{0, 1, 2}};
    const Scalp scalp = scalp_of(head_with(cap));
    EXPECT_TRUE(scalp.distance_towards({0, 0, 1}));
    EXPECT_FALSE(scalp.distance_towards({0, 0, -1}));
    EXPECT_FALSE(scalp.distance_towards({1, 0, 0}));
}

TEST(Scalp, TheWayOutOfASphereIsAwayFromItsMiddle) {
    for (const ScalpShape& shape :
         {ScalpShape(ScalpEllipsoid{{}, {0.1, 0.1, 0.1}}), ScalpShape(test::sphere_mesh({0.5, 1.5, -0.2}, 0.1, 64))}) {
        const Scalp scalp = scalp_of(head_with(shape));
        test::Random random(4);
        for (int i = 0; i < 200; ++i) {
            const Vec3 direction = random.direction();
            const auto way_out = scalp.way_out(0.06 * direction);
            ASSERT_TRUE(way_out);
            EXPECT_NEAR(length(*way_out), 0.04, 1.3e-4);
            EXPECT_TRUE(are_near(*way_out, 0.04 * direction, 2e-3));
            EXPECT_FALSE(scalp.way_out(0.101 * direction));
        }
        EXPECT_TRUE(scalp.way_out({}));
    }
}

TEST(Scalp, TheWayOutOfAnEllipsoidEndsOnIt) {
    const Vec3 radii{0.08, 0.12, 0.1};
    const Scalp scalp = scalp_of(head_with(ScalpEllipsoid{{}, radii}));
    test::Random random(5);
    for (int i = 0; i < 200; ++i) {
        const Vec3 point = 0.07 * random.direction();
        const Vec3 end = point + scalp.way_out(point).value();
        EXPECT_NEAR(length({end.x / radii.x, end.y / radii.z, end.z / radii.y}), 1, 1e-14);
    }
}

TEST(Scalp, BetweenTwoSurfacesOneIsOutside) {
    // As under a chin: the ray from the head's center leaves the skull and then meets the neck.
    ScalpMesh two = test::sphere_mesh({0.5, 1.5, -0.2}, 0.1, 16);
    const ScalpMesh neck = test::sphere_mesh({0.5, 1.2, -0.2}, 0.1, 16);
    const auto first = static_cast<std::uint32_t>(two.positions.size());
    two.positions.insert(two.positions.end(), neck.positions.begin(), neck.positions.end());
    for (const auto& [a, b, c] : neck.triangles) two.triangles.push_back({a + first, b + first, c + first});
    const Scalp scalp = scalp_of(head_with(two));
    EXPECT_TRUE(scalp.way_out({0, 0, -0.05}));
    EXPECT_FALSE(scalp.way_out({0, 0, -0.15}));
    EXPECT_TRUE(scalp.way_out({0, 0, -0.25}));
    EXPECT_FALSE(scalp.way_out({0, 0, -0.45}));
    EXPECT_DOUBLE_EQ(*scalp.distance_towards({0, 0, -1}), 0.4);  // a root goes on the last one
}

}  // namespace
}  // namespace tuftwave
