#include "tuftwave/fill_stroke.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "support.hpp"
#include "tuftwave/head.hpp"

namespace tuftwave {
namespace {

using test::are_near;

constexpr double kDegree = kRadiansPerDegree;
using Points = std::vector<Vec3>;

Vec3 away(const double azimuth_deg, const double elevation_deg, const double radius) {
    return radius * vector_towards({azimuth_deg * kDegree, elevation_deg * kDegree});
}

/// A lock that lies on the head and then hangs, with its root at this azimuth.
Points lock(const double azimuth_deg, const double reach = 1) {
    const Vec3 root = away(azimuth_deg, 40, 0.1), out = away(azimuth_deg + 10, 5, 0.06 * reach);
    return {root, root + out, root + out + Vec3{0.001, 0.002, -0.08 * reach}};
}

Gap gap_of(const Points& from, const Points& to, const bool is_ring = false,
           const FillDirection direction = FillDirection::kCounterClockwise) {
    FillSettings settings;
    settings.direction = direction;
    return *measure_gap(from[0], to[0], is_ring, settings, {});
}

Points turned_about_up(const Points& points, const double angle) {
    Points turned;
    for (const Vec3& point : points) turned.push_back(rotated(turn_about({0, 0, 1}, angle), point));
    return turned;
}

Points mirrored(Points points) {
    for (Vec3& point : points) point.x = -point.x;
    return points;
}

TEST(StrokesBetween, StartAndEndAtTheTwoStrokes) {
    const Points a = lock(0), b = lock(110, 1.5);
    const StrokesBetween between(a, b, gap_of(a, b));
    EXPECT_TRUE(are_near(between.stroke(0, 0), a, 1e-15));
    EXPECT_TRUE(are_near(between.stroke(1, 1), b, 1e-15));
}

TEST(StrokesBetween, OfAStrokeAndTheSameTurnedAreItTurnedPartOfTheWay) {
    const Points a = lock(-20);
    for (const double sweep_deg : {30.0, 170.0, 200.0, 340.0}) {
        const Points b = turned_about_up(a, sweep_deg * kDegree);
        const StrokesBetween between(a, b, gap_of(a, b));
        for (const double part : {0.25, 0.5, 0.8})
            EXPECT_TRUE(are_near(between.stroke(part, part), turned_about_up(a, part * sweep_deg * kDegree), 1e-14))
                << sweep_deg << " " << part;
    }
}

TEST(StrokesBetween, OfARingAreExactTurns) {
    const Points a = lock(70);
    const StrokesBetween between(a, a, gap_of(a, a, true));
    for (const double part : {0.2, 0.5, 0.9})
        EXPECT_TRUE(are_near(between.stroke(part, part), turned_about_up(a, part * 2 * kPi), 1e-15));
}

TEST(StrokesBetween, MirroredAreTheOnesThatGoTheOtherWay) {
    const Points a = lock(-20), b = lock(150, 0.7);
    const StrokesBetween between(a, b, gap_of(a, b));
    const StrokesBetween other(mirrored(a), mirrored(b),
                               gap_of(mirrored(a), mirrored(b), false, FillDirection::kClockwise));
    for (const double part : {0.1, 0.5, 0.7})
        EXPECT_TRUE(are_near(other.stroke(part, part), mirrored(between.stroke(part, part)), 1e-14));
}

TEST(StrokesBetween, StepsHaveLengthsBetweenTheTwo) {
    const Points a = lock(0), b = lock(80, 2);
    const Points middle = StrokesBetween(a, b, gap_of(a, b)).stroke(0.3, 0.25);  // eq. (6) goes by l / (N + 1)
    for (std::size_t i = 1; i < a.size(); ++i)
        EXPECT_NEAR(length(middle[i] - middle[i - 1]), 0.75 * length(a[i] - a[i - 1]) + 0.25 * length(b[i] - b[i - 1]),
                    1e-15);
}

TEST(StrokesBetween, AStepThatTurnsALittleLessThanTheRootTakesTheShortWay) {
    // Root at 0 and 10 degrees, step at 0 and -3: from 0 to -3 the paper's [0, 2 pi) would go through 357.
    const Points a{away(0, 30, 0.1), away(0, 30, 0.1) + away(0, -50, 0.05)};
    const Points b{away(10, 30, 0.1), away(10, 30, 0.1) + away(-3, -50, 0.05)};
    const Points middle = StrokesBetween(a, b, gap_of(a, b)).stroke(0.5, 0.5);
    EXPECT_NEAR(bearing_of(middle[1] - middle[0]).azimuth, -1.5 * kDegree, 1e-12);
}

TEST(StrokesBetween, AStepFollowsARootThatGoesMoreThanHalfAround) {
    // Root by 200 degrees, step by 210: the short way between the steps would be -150, against the root.
    const Points a{away(0, 30, 0.1), away(0, 30, 0.1) + away(0, -50, 0.05)};
    const Points b{away(200, 30, 0.1), away(200, 30, 0.1) + away(210, -50, 0.05)};
    const Points middle = StrokesBetween(a, b, gap_of(a, b)).stroke(0.5, 0.5);
    EXPECT_NEAR(bearing_of(middle[1] - middle[0]).azimuth, 105 * kDegree, 1e-12);
}

TEST(StrokesBetween, AVerticalStepKeepsTheOthersAngleToItsRoot) {
    // A hangs straight down and has no azimuth there; B leans 15 degrees from its root's. With atan2's zero for A the
    // steps between would swing through the head.
    const Points a{away(60, 30, 0.1), away(60, 30, 0.1) + Vec3{0, 0, -0.05}};
    const Points b{away(100, 30, 0.1), away(100, 30, 0.1) + away(115, -60, 0.05)};
    const Points middle = StrokesBetween(a, b, gap_of(a, b)).stroke(0.5, 0.5);
    EXPECT_NEAR(bearing_of(middle[1] - middle[0]).azimuth, 95 * kDegree, 1e-12);
    const Points back = StrokesBetween(b, a, gap_of(b, a, false, FillDirection::kClockwise)).stroke(0.5, 0.5);
    EXPECT_TRUE(are_near(back, middle, 1e-14));
}

TEST(StrokesBetween, TwoVerticalStepsStayVertical) {
    const Points a{away(0, 30, 0.1), away(0, 30, 0.1) + Vec3{0, 0, -0.05}};
    const Points b{away(90, 30, 0.1), away(90, 30, 0.1) + Vec3{0, 0, -0.07}};
    const Points middle = StrokesBetween(a, b, gap_of(a, b)).stroke(0.5, 0.5);
    EXPECT_TRUE(are_near(middle[1] - middle[0], {0, 0, -0.06}, 1e-16));
}

TEST(StrokesBetween, AStepWithoutLengthGrowsIntoTheOthersDirection) {
    const Points a{away(0, 30, 0.1), away(0, 30, 0.1), away(0, 0, 0.12)};
    const Points b{away(40, 30, 0.1), away(40, 30, 0.1) + away(50, -20, 0.02), away(40, 0, 0.12)};
    const Points middle = StrokesBetween(a, b, gap_of(a, b)).stroke(0.5, 0.5);
    const Bearing step = bearing_of(middle[1] - middle[0]);
    EXPECT_NEAR(length(middle[1] - middle[0]), 0.01, 1e-15);
    EXPECT_NEAR(step.azimuth, 30 * kDegree, 1e-12);
    EXPECT_NEAR(step.elevation, -20 * kDegree, 1e-12);
}

TEST(Resampled, KeepsTheEndsAndSpacesEvenly) {
    const Points points = lock(30);
    const Points even = resampled(points, 9);
    ASSERT_EQ(even.size(), 9u);
    EXPECT_TRUE(are_near(even.front(), points.front(), 1e-15));
    EXPECT_TRUE(are_near(even.back(), points.back(), 1e-15));
    const double first = length(even[1] - even[0]);
    for (std::size_t i = 2; i < 9; ++i)
        EXPECT_NEAR(length(even[i] - even[i - 1]), first, 0.1 * first);  // chords of equal arcs
}

}  // namespace
}  // namespace tuftwave
