#include "tuftwave/limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "support.hpp"

namespace tuftwave {
namespace {

using test::is_refused;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Range kRange{-2, 3.5};

TEST(Limits, BothEndsBelongToARange) {
    EXPECT_TRUE(is_within(-2, kRange));
    EXPECT_TRUE(is_within(3.5, kRange));
    EXPECT_FALSE(is_within(std::nextafter(-2, -3), kRange));
    EXPECT_FALSE(is_within(std::nextafter(3.5, 4), kRange));
    EXPECT_FALSE(is_within(kNaN, kRange));
}

TEST(Limits, CheckRangeTellsWhatIsNoNumberFromWhatIsOutside) {
    EXPECT_FALSE(check_range(0, kRange, "/a"));
    EXPECT_TRUE(is_refused(check_range(4, kRange, "/a"), ErrorCode::kOutOfRange, "/a"));
    EXPECT_TRUE(is_refused(check_range(-1e300, kRange, "/a"), ErrorCode::kOutOfRange, "/a"));
    EXPECT_TRUE(is_refused(check_range(kNaN, kRange, "/a"), ErrorCode::kNotFinite, "/a"));
    EXPECT_TRUE(is_refused(check_range(kInfinity, kRange, "/a"), ErrorCode::kNotFinite, "/a"));
    EXPECT_TRUE(is_refused(check_range(-kInfinity, kRange, "/a"), ErrorCode::kNotFinite, "/a"));
}

TEST(Limits, ARefusalSaysWhatWasGivenAndWhatIsAllowed) {
    const Check wrong = check_range(4, kRange, "/a");
    ASSERT_TRUE(wrong);
    EXPECT_EQ(std::get<double>(wrong->given), 4);
    EXPECT_EQ(wrong->allowed, "-2 to 3.5");
    EXPECT_EQ(wrong->minimum, -2);
    EXPECT_EQ(wrong->maximum, 3.5);
}

TEST(Limits, CheckMagnitudeRefusesAGapAroundZero) {
    constexpr Range kMagnitude{0.05, 100};
    for (const double good : {0.05, 100.0, -0.05, -100.0, 1.0})
        EXPECT_FALSE(check_magnitude(good, kMagnitude, "")) << good;
    for (const double bad : {0.0, -0.0, 0.049, -0.049, 101.0, -101.0}) {
        EXPECT_TRUE(is_refused(check_magnitude(bad, kMagnitude, "/k"), ErrorCode::kOutOfRange, "/k")) << bad;
    }
    EXPECT_TRUE(is_refused(check_magnitude(kNaN, kMagnitude, "/k"), ErrorCode::kNotFinite, "/k"));
    EXPECT_TRUE(is_refused(check_magnitude(-kInfinity, kMagnitude, "/k"), ErrorCode::kNotFinite, "/k"));
    EXPECT_EQ(check_magnitude(0, kMagnitude, "")->allowed, "0.05 to 100 or -100 to -0.05");
}

TEST(Limits, CheckCountNamesTheSideThatFailed) {
    EXPECT_FALSE(check_count(2, 2, 5, "/list"));
    EXPECT_FALSE(check_count(5, 2, 5, "/list"));
    EXPECT_TRUE(is_refused(check_count(1, 2, 5, "/list"), ErrorCode::kTooFew, "/list"));
    EXPECT_TRUE(is_refused(check_count(6, 2, 5, "/list"), ErrorCode::kTooMany, "/list"));
    EXPECT_EQ(check_count(6, 2, 5, "")->allowed, "2 to 5");
}

TEST(Limits, NumbersAreWrittenAsPeopleWriteThem) {
    EXPECT_EQ(to_text(0.45), "0.45");
    EXPECT_EQ(to_text(24), "24");
    EXPECT_EQ(to_text(-3600), "-3600");
    EXPECT_EQ(to_text(0.1), "0.1");
}

TEST(Limits, WhatIsPutInFrontOfAFieldKeepsTheRest) {
    EXPECT_EQ(within("/motion", Error{ErrorCode::kOutOfRange, "/wave", 1.0, "x", {}, {}}).field, "/motion/wave");
}

TEST(Limits, JointIndicesFitSixteenBits) {
    const Limits limits;
    EXPECT_LE(limits.joints, std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1);
}

TEST(Limits, ATuftsChainIsAllowedAsAChain) {
    const Limits limits;
    EXPECT_LE(limits.joints_per_tuft.maximum + 1, static_cast<double>(limits.nodes_per_chain));
    EXPECT_LE(limits.tufts, limits.chains);
    EXPECT_LE(limits.rings.maximum, static_cast<double>(limits.rings_per_tuft));
}

TEST(Limits, TheLongestCycleStaysBelowHalfOfTheMostPictures) {
    const Limits limits;
    EXPECT_LT(2 * limits.cycles.maximum, static_cast<double>(limits.pictures));
}

TEST(Result, HoldsAValueOrAnError) {
    const Result<int> good = 3;
    const Result<int> bad = Error{ErrorCode::kCancelled, "/x", {}, "", {}, {}};
    ASSERT_TRUE(good);
    EXPECT_EQ(*good, 3);
    EXPECT_TRUE(is_refused(bad, ErrorCode::kCancelled, "/x"));
}

}  // namespace
}  // namespace tuftwave
