#include "tuftwave/head.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "support.hpp"

namespace tuftwave {
namespace {

using test::are_near;
using test::is_refused;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(CheckHead, AcceptsTheDefault) { EXPECT_FALSE(check_head({}, {})); }

TEST(CheckHead, RefusesWithCodeAndField) {
    const struct {
        const char* name;
        std::function<void(Head&)> change;
        ErrorCode code;
        const char* field;
    } cases[] = {
        {"center far away", [](Head& h) { h.center.y = 1e7; }, ErrorCode::kOutOfRange, "/center/1"},
        {"center not a number", [](Head& h) { h.center.x = kNaN; }, ErrorCode::kNotFinite, "/center/0"},
        {"up without length", [](Head& h) { h.up = {}; }, ErrorCode::kDegenerate, "/up"},
        {"up not a number", [](Head& h) { h.up.z = kNaN; }, ErrorCode::kNotFinite, "/up/2"},
        {"front without length", [](Head& h) { h.front = {}; }, ErrorCode::kDegenerate, "/front"},
        {"front along up",
         [](Head& h) {
             h.front = {0, 2, 0};
         },
         ErrorCode::kDegenerate, "/front"},
        {"front against up",
         [](Head& h) {
             h.front = {0, -2, 0};
         },
         ErrorCode::kDegenerate, "/front"},
        {"negative depth", [](Head& h) { h.root_depth = -0.01; }, ErrorCode::kOutOfRange, "/root_depth"},
        {"depth not a number", [](Head& h) { h.root_depth = kNaN; }, ErrorCode::kNotFinite, "/root_depth"},
        {"scalp without width",
         [](Head& h) {
             h.scalp = ScalpEllipsoid{{}, {0, 0.1, 0.1}};
         },
         ErrorCode::kOutOfRange, "/scalp/ellipsoid/radii/0"},
        {"scalp around something else",
         [](Head& h) {
             h.scalp = ScalpEllipsoid{Vec3{0, 0.15, 0}, {1, 0.1, 1}};
         },
         ErrorCode::kDegenerate, "/scalp/ellipsoid"},
        {"no diameter", [](Head& h) { h.diameter_at_100 = 0; }, ErrorCode::kOutOfRange, "/diameter_at_100"},
    };
    for (const auto& wrong : cases) {
        Head head;
        wrong.change(head);
        EXPECT_TRUE(is_refused(check_head(head, {}), wrong.code, wrong.field)) << wrong.name;
    }
}

TEST(SunkRoot, LiesTheDepthBelowTheScalpTowardsTheCenter) {
    Head head;
    head.center = {1, 2, 3};
    head.root_depth = 0.01;
    EXPECT_TRUE(are_near(sunk_root(head, {1, 2.1, 3}), {1, 2.09, 3}, 1e-15));

    test::Random random(1);
    for (int i = 0; i < 100; ++i) {
        const Vec3 root = head.center + random.between(0.02, 5) * random.direction();
        const Vec3 sunk = sunk_root(head, root);
        EXPECT_NEAR(length(sunk - root), 0.01, 1e-14);
        EXPECT_NEAR(length(sunk - head.center), length(root - head.center) - 0.01, 1e-14);
    }
}

TEST(SunkRoot, NeverPassesTheCenter) {
    Head head;
    head.root_depth = 0.2;
    EXPECT_EQ(sunk_root(head, {0, 0.1, 0}), head.center);
    EXPECT_EQ(sunk_root(head, {0, 0.2, 0}), head.center);
}

TEST(SunkRoot, WithoutDepthIsTheRootItself) {
    Head head;
    head.root_depth = 0;
    const Vec3 root{0.03, 0.1, -0.02};
    EXPECT_EQ(sunk_root(head, root), root);
}

TEST(HeadFrame, HasTheLeftEarOnXTheFaceAgainstYAndTheCrownOnZ) {
    Head head;
    head.center = {1, 2, 3};
    const HeadFrame frame(head);
    EXPECT_EQ(frame.to_head({2, 2, 3}), (Vec3{1, 0, 0}));   // glTF's +X is the character's left
    EXPECT_EQ(frame.to_head({1, 2, 4}), (Vec3{0, -1, 0}));  // glTF's +Z is the face
    EXPECT_EQ(frame.to_head({1, 3, 3}), (Vec3{0, 0, 1}));   // glTF's +Y is up
}

TEST(HeadFrame, GoesBackToWhereItCameFromForAnyHead) {
    test::Random random(2);
    for (int i = 0; i < 100; ++i) {
        Head head;
        head.center = random.in_cube(1);
        head.up = random.between(0.1, 10) * random.direction();
        head.front = random.between(0.1, 10) * random.direction();
        if (check_head(head, {})) continue;
        const HeadFrame frame(head);
        const Vec3 point = random.in_cube(2);
        EXPECT_TRUE(are_near(frame.to_model(frame.to_head(point)), point, 1e-14));
        EXPECT_NEAR(length(frame.to_head(point)), length(point - head.center), 1e-14);
        EXPECT_TRUE(are_near(frame.to_head(head.center + normalized(head.up)), {0, 0, 1}, 1e-14));
    }
}

TEST(HeadFrame, TakesOnlyThePartOfTheFrontThatIsLevel) {
    Head head;
    head.front = {0, 5, 1};
    EXPECT_TRUE(are_near(HeadFrame(head).to_head({0, 0, 1}), {0, -1, 0}, 1e-15));
}

TEST(Bearing, CountsAzimuthFromTheLeftEarCounterClockwiseSeenFromAbove) {
    EXPECT_EQ(bearing_of({2, 0, 0}).azimuth, 0);
    EXPECT_NEAR(bearing_of({0, 3, 0}).azimuth, kPi / 2, 1e-15);
    EXPECT_NEAR(bearing_of({0, -1, 0}).azimuth, -kPi / 2, 1e-15);
    EXPECT_NEAR(bearing_of({0, -1, -1}).elevation, -kPi / 4, 1e-15);
}

TEST(Bearing, IsUndoneByVectorTowards) {
    test::Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 direction = random.direction();
        EXPECT_TRUE(are_near(vector_towards(bearing_of(direction)), direction, 1e-15));
    }
}

TEST(Bearing, OfAVerticalVectorHasAzimuthZero) {
    for (const Vec3& vertical : {Vec3{0, 0, 1}, Vec3{1e-10, -1e-10, -0.5}, Vec3{}}) {
        EXPECT_TRUE(is_vertical(vertical));
        EXPECT_EQ(bearing_of(vertical).azimuth, 0);
    }
    EXPECT_FALSE(is_vertical({1e-8, 0, 1}));
}

TEST(TurnAlongMeridian, AddsToAzimuthAndElevation) {
    test::Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const Bearing from{random.between(-kPi, kPi), random.between(-1, 1)};
        const Bearing by{random.between(-0.5, 0.5), random.between(-0.5, 0.5)};
        const Vec3 turned = rotated(turn_along_meridian(from.azimuth, by), vector_towards(from));
        EXPECT_TRUE(
            are_near(turned, vector_towards({from.azimuth + by.azimuth, from.elevation + by.elevation}), 1e-14));
    }
}

TEST(Hairline, FollowsEquationEight) {
    const double degree = kRadiansPerDegree;
    const struct {
        double azimuth_deg, elevation_deg;
        bool grows;
    } cases[] = {
        {-90, 1, true},     // on the forehead
        {-90, -1, false},   // on the face
        {-149, -1, false},  // its right edge, inside
        {-151, -1, true},   // and outside
        {-31, -1, false},   // its left edge, inside
        {-29, -1, true},    // and outside
        {90, -59, true},    // above the neck
        {90, -61, false},   // on the neck
        {270, -1, false},   // the face once around
        {-450, -1, false},  // and the other way
    };
    for (const auto& c : cases)
        EXPECT_EQ(is_within_hairline({c.azimuth_deg * degree, c.elevation_deg * degree}), c.grows)
            << c.azimuth_deg << " " << c.elevation_deg;
}

TEST(Hairline, ExcludesItsBorders) {
    // As printed (8) is strict in elevation, and at the two azimuths the lower bound holds.
    EXPECT_FALSE(is_within_hairline({-kPi / 2, 0}));
    EXPECT_FALSE(is_within_hairline({-kPi / 2, 1e-12}));
    EXPECT_FALSE(is_within_hairline({kPi / 2, -kPi / 3}));
    EXPECT_TRUE(is_within_hairline({-kPi / 6, -0.5}));
    EXPECT_TRUE(is_within_hairline({-5 * kPi / 6, -0.5}));
}

}  // namespace
}  // namespace tuftwave
