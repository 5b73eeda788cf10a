#include "tuftwave/profile.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tuftwave/math.hpp"

namespace tuftwave {
namespace {

constexpr Taper kTapers[] = {Taper::kSine, Taper::kLinear, Taper::kSmooth, Taper::kRound};
/// Both ends of the range of p, the default, and the value next to a flat tip.
constexpr double kWidestPlaces[] = {0.01, 0.4, 0.5, 0.99};

TEST(Profile, RunsFromNothingToFullWidthToNothing) {
    for (const Taper taper : kTapers) {
        for (const double widest : kWidestPlaces) {
            EXPECT_EQ(profile_width(taper, 0, widest), 0);
            EXPECT_EQ(profile_width(taper, widest, widest), 1);
            EXPECT_EQ(profile_width(taper, 1, widest), 0);
        }
    }
}

TEST(Profile, EndsAtFullWidthWhereTheTipIsTheWidestPlace) {
    for (const Taper taper : kTapers) {
        EXPECT_EQ(profile_width(taper, 0, 1), 0);
        EXPECT_EQ(profile_width(taper, 1, 1), 1);
    }
}

TEST(Profile, RisesToTheWidestPlaceAndFallsAfterIt) {
    constexpr int kSteps = 1000;
    for (const Taper taper : kTapers) {
        for (const double widest : kWidestPlaces) {
            for (int i = 0; i < kSteps; ++i) {
                const double here = static_cast<double>(i) / kSteps, next = static_cast<double>(i + 1) / kSteps;
                const double rise = profile_width(taper, next, widest) - profile_width(taper, here, widest);
                EXPECT_TRUE(next > widest || rise > 0) << "step " << i << ", widest at " << widest;
                EXPECT_TRUE(here < widest || rise < 0) << "step " << i << ", widest at " << widest;
            }
        }
    }
}

TEST(Profile, StaysWithinNothingAndFullWidthOutsideTheTuftToo) {
    for (const Taper taper : kTapers) {
        for (const double along : {-1.0, -1e-12, 1 + 1e-12, 2.0}) EXPECT_EQ(profile_width(taper, along, 0.4), 0);
        for (int i = 0; i <= 1000; ++i) {
            const double width = profile_width(taper, i / 1000.0, 0.37);
            EXPECT_TRUE(width >= 0 && width <= 1) << i;
        }
    }
}

TEST(Profile, EachTaperHasItsShapeHalfwayUp) {
    EXPECT_NEAR(profile_width(Taper::kSine, 0.2, 0.4), std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(profile_width(Taper::kLinear, 0.2, 0.4), 0.5, 1e-15);
    EXPECT_NEAR(profile_width(Taper::kSmooth, 0.2, 0.4), 0.5, 1e-15);
    EXPECT_NEAR(profile_width(Taper::kRound, 0.2, 0.4), std::sqrt(0.75), 1e-15);
}

TEST(Profile, FallsAsItRoseWhereTheMiddleIsWidest) {
    for (const Taper taper : kTapers) {
        for (int i = 0; i <= 50; ++i) {
            EXPECT_NEAR(profile_width(taper, i / 100.0, 0.5), profile_width(taper, 1 - i / 100.0, 0.5), 1e-15);
        }
    }
}

}  // namespace
}  // namespace tuftwave
