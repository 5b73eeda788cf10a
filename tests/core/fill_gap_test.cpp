#include "tuftwave/fill_gap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "support.hpp"
#include "tuftwave/head.hpp"

namespace tuftwave {
namespace {

constexpr double kDegree = kRadiansPerDegree;

Vec3 root(const double azimuth_deg, const double elevation_deg, const double radius = 0.1) {
    return radius * vector_towards({azimuth_deg * kDegree, elevation_deg * kDegree});
}

Gap gap_between(const Vec3& from, const Vec3& to, const FillSettings& settings = {}) {
    return *measure_gap(from, to, false, settings, {});
}

FillSettings going(const FillDirection direction) {
    FillSettings settings;
    settings.direction = direction;
    return settings;
}

TEST(Gap, GoesCounterClockwiseSeenFromAbove) {
    EXPECT_NEAR(gap_between(root(10, 0), root(100, 0)).sweep, 90 * kDegree, 1e-14);
    EXPECT_NEAR(gap_between(root(100, 0), root(10, 0)).sweep, 270 * kDegree, 1e-14);  // more than half around
    EXPECT_NEAR(gap_between(root(170, 0), root(-170, 0)).sweep, 20 * kDegree, 1e-14);
}

TEST(Gap, GoesClockwiseOrTheShorterWayWhereAsked) {
    const Vec3 a = root(10, 0), b = root(100, 0);
    EXPECT_NEAR(gap_between(a, b, going(FillDirection::kClockwise)).sweep, -270 * kDegree, 1e-14);
    EXPECT_NEAR(gap_between(b, a, going(FillDirection::kClockwise)).sweep, -90 * kDegree, 1e-14);
    EXPECT_NEAR(gap_between(a, b, going(FillDirection::kShorter)).sweep, 90 * kDegree, 1e-14);
    EXPECT_NEAR(gap_between(b, a, going(FillDirection::kShorter)).sweep, -90 * kDegree, 1e-14);
}

TEST(Gap, BetweenRootsAtOneAzimuthDoesNotTurnEitherWay) {
    // Rounding must not make a whole turn of it: 2 pi - 1e-15 counts as none.
    for (const auto direction :
         {FillDirection::kCounterClockwise, FillDirection::kClockwise, FillDirection::kShorter}) {
        EXPECT_EQ(gap_between(root(50, 0), root(50, 40), going(direction)).sweep, 0);
        EXPECT_NEAR(gap_between({0.1, -1e-17, 0}, {0.1, 1e-17, 0.05}, going(direction)).sweep, 0, 1e-15);
    }
    const Gap up = gap_between(root(50, 0), root(50, 40));
    EXPECT_NEAR(up.gamma, 40 * kDegree, 1e-12);
    EXPECT_NEAR(up.rise, 40 * kDegree, 1e-14);
    EXPECT_NEAR(gap_between(root(50, 40), root(50, 0)).rise, -40 * kDegree, 1e-14);  // beta is signed
}

TEST(Gap, BetweenEqualRootsIsNoneAndTakesNoTuft) {
    const Gap gap = gap_between(root(30, 20), root(30, 20));
    EXPECT_EQ(gap.distance, 0);
    EXPECT_EQ(gap.along, 0u);
}

TEST(Gap, ARootOnTheUpAxisTakesTheOthersAzimuth) {
    // It has no azimuth of its own; with atan2's zero, tufts would fan out to the left ear.
    const Gap from_pole = gap_between({0, 0, 0.1}, root(140, 30));
    EXPECT_NEAR(from_pole.azimuth, 140 * kDegree, 1e-14);
    EXPECT_EQ(from_pole.sweep, 0);
    EXPECT_NEAR(from_pole.rise, -60 * kDegree, 1e-14);
    EXPECT_EQ(gap_between(root(140, 30), {1e-12, 0, 0.1}).sweep, 0);
    EXPECT_EQ(gap_between({0, 0, 0.1}, {0, 0, 0.2}).sweep, 0);
}

TEST(Gap, ARingGoesOnceAround) {
    const Gap ring = *measure_gap(root(10, 50), root(10, 50), true, {}, {});
    EXPECT_EQ(ring.sweep, 2 * kPi);
    EXPECT_EQ(ring.rise, 0);
    EXPECT_DOUBLE_EQ(ring.gamma, 2 * kPi);
    EXPECT_EQ(measure_gap(root(10, 50), root(10, 50), true, going(FillDirection::kClockwise), {})->sweep, -2 * kPi);
}

TEST(Gap, FollowsEquationsOneToThree) {
    FillSettings settings;
    settings.tufts_per_meter = 200;
    settings.density.along = 40;
    const Gap gap = gap_between(root(0, 0, 0.1), root(60, 30, 0.14), settings);
    const double gamma = std::acos(std::cos(30 * kDegree) * std::cos(60 * kDegree));
    EXPECT_NEAR(gap.gamma, gamma, 1e-14);
    EXPECT_NEAR(gap.distance, 0.12 * gamma, 1e-14);
    EXPECT_EQ(gap.along, static_cast<std::size_t>(40 * 200 * 0.12 * gamma / 100));
}

TEST(Gap, ByEquationTwoGoesOnBeyondHalfATurn) {
    // Without the paper's case for alpha > pi a sweep of 190 degrees would be measured as one of 170.
    EXPECT_NEAR(gap_between(root(0, 0), root(190, 0)).gamma, 190 * kDegree, 1e-12);
    EXPECT_NEAR(gap_between(root(0, 0), root(190, 10)).gamma,
                2 * kPi - std::acos(std::cos(10 * kDegree) * std::cos(190 * kDegree)), 1e-14);
}

TEST(Gap, ByItsPathIsShorterNearTheCrown) {
    FillSettings path;
    path.arc = Arc::kPath;
    EXPECT_NEAR(gap_between(root(0, 0), root(120, 0), path).gamma, 120 * kDegree, 1e-12);
    EXPECT_NEAR(measure_gap(root(0, 60), root(0, 60), true, path, {})->gamma, kPi, 1e-12);  // 2 pi cos 60
    // Against a thousand straight pieces.
    double pieces = 0;
    for (int i = 0; i < 1000; ++i) {
        const double u = i / 1000.0, v = (i + 1) / 1000.0;
        pieces += length(root(200 * v, 10 + 60 * v, 1) - root(200 * u, 10 + 60 * u, 1));
    }
    EXPECT_NEAR(gap_between(root(0, 10), root(200, 70), path).gamma, pieces, 1e-5);
}

TEST(Gap, TakesThirtyTwoTuftsAroundAHeadOfAnySizeUnlessToldOtherwise) {
    FillSettings dense;
    dense.density.along = 100;
    for (const double radius : {0.001, 0.1, 3.0, 1e5})
        EXPECT_EQ(measure_gap(root(20, 10, radius), root(20, 10, radius), true, dense, {})->along, 32u) << radius;
}

TEST(Gap, NeverTakesFewerTuftsWhenDenser) {
    test::Random random(1);
    for (int i = 0; i < 50; ++i) {
        const Vec3 a = 0.1 * random.direction(), b = 0.12 * random.direction();
        std::size_t before = 0;
        for (double density = 1; density <= 100; density += 0.5) {
            FillSettings settings;
            settings.density.along = density;
            const std::size_t along = gap_between(a, b, settings).along;
            EXPECT_GE(along, before);
            before = along;
        }
    }
}

TEST(Gap, MayBeTooNarrowForATuft) {
    FillSettings sparse;
    sparse.density.along = 1;
    EXPECT_EQ(gap_between(root(0, 0), root(90, 0), sparse).along, 0u);
    FillSettings off;
    off.density.along.reset();
    EXPECT_EQ(gap_between(root(0, 0), root(90, 0), off).along, 0u);
}

TEST(Gap, ThatWouldTakeTooManySaysHowMany) {
    FillSettings settings;
    settings.tufts_per_meter = 1e6;
    settings.density.along = 100;
    const auto refused = measure_gap(root(0, 0, 1), root(180, 0, 1), false, settings, {});
    ASSERT_TRUE(test::is_refused(refused, ErrorCode::kTooMany, "/density/along"));
    EXPECT_EQ(std::get<double>(refused.error().given), std::floor(1e6 * kPi));
}

// From 10 to 60 over four tufts: whole tens, and the three spacings differ.
TEST(Spread, ByDiameterGivesEachTuftAndTheLastOneItsOwnRoom) {
    const std::vector<double> shares = spread_along(4, 10, 60, Spacing::kDiameter);
    // (4): 20, 30, 40, 50 and then the second tuft's 60, of 200.
    EXPECT_EQ(shares.size(), 4u);
    const double expected[] = {20 / 200.0, 50 / 200.0, 90 / 200.0, 140 / 200.0};
    for (std::size_t l = 0; l < 4; ++l) EXPECT_NEAR(shares[l], expected[l], 1e-15);
}

TEST(Spread, AsPrintedLandsOnTheSecondTuft) {
    const std::vector<double> shares = spread_along(4, 10, 60, Spacing::kAsPrinted);
    const double expected[] = {20 / 140.0, 50 / 140.0, 90 / 140.0, 1};
    for (std::size_t l = 0; l < 4; ++l) EXPECT_NEAR(shares[l], expected[l], 1e-15);
}

TEST(Spread, ByHalfGapsIsTheSameFromBothSides) {
    const std::vector<double> forth = spread_along(7, 10, 60, Spacing::kHalfGap);
    const std::vector<double> back = spread_along(7, 60, 10, Spacing::kHalfGap);
    for (std::size_t l = 0; l < 7; ++l) EXPECT_NEAR(forth[l], 1 - back[6 - l], 1e-15);
}

TEST(Spread, OfEqualDiametersIsEven) {
    for (const Spacing spacing : {Spacing::kDiameter, Spacing::kHalfGap}) {
        const std::vector<double> shares = spread_along(9, 40, 40, spacing);
        for (std::size_t l = 0; l < 9; ++l) EXPECT_NEAR(shares[l], static_cast<double>(l + 1) / 10, 1e-15);
    }
}

TEST(Spread, OfNoTuftIsEmpty) {
    for (const Spacing spacing : {Spacing::kDiameter, Spacing::kHalfGap, Spacing::kAsPrinted})
        EXPECT_TRUE(spread_along(0, 40, 20, spacing).empty());
}

}  // namespace
}  // namespace tuftwave
