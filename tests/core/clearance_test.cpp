#include "tuftwave/clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "support.hpp"
#include "tuftwave/curve.hpp"

namespace tuftwave {
namespace {

using Points = std::vector<Vec3>;

Scalp ball() {
    Head head;
    head.scalp = ScalpEllipsoid{{}, {0.1, 0.1, 0.1}};
    return *Scalp::of(head);
}

const Clearance kEverywhere(kClearanceShares + 1, true);

/// How deep a stroke's line dips below a ball of 10 cm radius, metres; finer than bend_outwards looks.
double deepest(const Points& stroke) {
    const Curve curve(stroke);
    double depth = 0;
    for (int i = 0; i <= 500; ++i) depth = std::max(depth, 0.1 - length(curve.at(curve.arc_length() * i / 500).point));
    return depth;
}

TEST(Clearance, TellsWhereALineIsOutside) {
    // From 1 cm below the surface straight out to 5 cm above it: a sixth is inside.
    const Clearance clearance = clearance_of(Points{{0, 0, 0.1}, {0, 0, 0.15}}, ball(), 0.01);
    ASSERT_EQ(clearance.size(), static_cast<std::size_t>(kClearanceShares + 1));
    for (std::size_t i = 0; i < clearance.size(); ++i) {
        if (6 * i == kClearanceShares) continue;  // on the surface itself
        EXPECT_EQ(clearance[i], 6 * i > kClearanceShares) << i;
    }
}

TEST(Clearance, IsCommonWhereBothAreOutside) {
    EXPECT_EQ(common_clearance({true, true, false, false}, {true, false, true, false}),
              (Clearance{true, false, false, false}));
}

TEST(BendOutwards, LeavesAStrokeAloneThatIsOutside) {
    Points stroke{{0, 0, 0.1}, {0.05, 0, 0.13}, {0.2, 0, 0.1}};
    const Points before = stroke;
    EXPECT_EQ(bend_outwards(stroke, clearance_of(stroke, ball(), 0.01), ball(), 0.01), Bend::kNone);
    EXPECT_EQ(stroke, before);
}

TEST(BendOutwards, BringsALineOutThatCutsThroughTheHead) {
    // Down from the crown through the head; the second has a point to bend at, the third several.
    for (const Points& drawn :
         {Points{{0, 0, 0.1}, {0.14, 0, -0.02}}, Points{{0, 0, 0.1}, {0.06, 0, 0.06}, {0.12, 0, -0.1}},
          Points{{0, 0, 0.1}, {0.03, 0, 0.09}, {0.06, 0, 0.05}, {0.08, 0, 0}, {0.09, 0, -0.12}}}) {
        Points stroke = drawn;
        EXPECT_GT(deepest(stroke), 0.001);
        EXPECT_EQ(bend_outwards(stroke, kEverywhere, ball(), 0), Bend::kBent);
        EXPECT_LT(deepest(stroke), 1e-4);  // a tenth of a millimetre
        EXPECT_EQ(stroke.front(), drawn.front());
        EXPECT_EQ(stroke.size(), drawn.size());
    }
}

TEST(BendOutwards, RaisesAStrokeThatLeavesItsRootTooFlat) {
    // Drawn a centimetre above the scalp and put on it: the straight line dips 3 mm, and its tip has to come out far.
    const Points drawn{{0, -0.05, 0.1}, {0, -0.1, 0.05}};
    Points stroke;
    for (const Vec3& point : drawn) stroke.push_back(point - 0.106 * length(drawn[0]) * normalized(drawn[0]));
    stroke[0] = 0.1 * normalized(drawn[0]);
    EXPECT_EQ(bend_outwards(stroke, clearance_of(drawn, ball(), 0.01), ball(), 0.01), Bend::kBent);
    EXPECT_LT(deepest({stroke.begin(), stroke.end()}), 2e-4);
}

TEST(BendOutwards, MovesAllThatHangsFromTheBendAlike) {
    const Points drawn{{0, 0, 0.1}, {0.09, 0, 0.02}, {0.11, 0, -0.1}, {0.12, 0.01, -0.2}};
    Points stroke = drawn;
    ASSERT_EQ(bend_outwards(stroke, kEverywhere, ball(), 0), Bend::kBent);
    EXPECT_TRUE(test::are_near(stroke[3] - stroke[2], drawn[3] - drawn[2], 1e-15));
}

TEST(BendOutwards, DoesNotCareWhereItIsNotWanted) {
    Points stroke{{0, 0, 0.1}, {0.06, 0, 0.06}, {0.12, 0, -0.1}};
    const Points before = stroke;
    EXPECT_EQ(bend_outwards(stroke, Clearance(kClearanceShares + 1, false), ball(), 0.01), Bend::kNone);
    EXPECT_EQ(stroke, before);
}

TEST(BendOutwards, IsStuckWhereNothingOfTheStrokeWouldBeLeft) {
    // Its tip in the middle of the head goes out the way it came, until it meets the root.
    for (const double root_depth : {0.0, 0.01}) {
        Points stroke{{0, 0, 0.1}, {0, 0, 0}};
        EXPECT_EQ(bend_outwards(stroke, kEverywhere, ball(), root_depth), Bend::kStuck) << root_depth;
    }
}

}  // namespace
}  // namespace tuftwave
