#include "tuftwave/vector_checks.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "support.hpp"

namespace tuftwave {
namespace {

using test::is_refused;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Limits kLimits;

TEST(CheckPosition, NamesTheFirstWrongCoordinate) {
    EXPECT_FALSE(check_position({1e6, -1e6, 0}, kLimits, "/p"));
    EXPECT_TRUE(is_refused(check_position({kNaN, kNaN, 0}, kLimits, "/p"), ErrorCode::kNotFinite, "/p/0"));
    EXPECT_TRUE(is_refused(check_position({0, -kInfinity, 2e6}, kLimits, "/p"), ErrorCode::kNotFinite, "/p/1"));
    EXPECT_TRUE(is_refused(check_position({0, 0, 2e6}, kLimits, "/p"), ErrorCode::kOutOfRange, "/p/2"));
}

TEST(CheckPositions, NamesTheFirstWrongPoint) {
    EXPECT_FALSE(check_positions({}, kLimits, "/list"));
    const std::vector<Vec3> points{{0, 0, 1}, {0, 2e6, 0}, {kNaN, 0, 0}};
    EXPECT_FALSE(check_positions({points.data(), 1}, kLimits, "/list"));
    EXPECT_TRUE(is_refused(check_positions(points, kLimits, "/list"), ErrorCode::kOutOfRange, "/list/1/1"));
}

TEST(CheckDirection, NeedsALength) {
    EXPECT_FALSE(check_direction({0, -3, 0}, kLimits, "/up"));
    EXPECT_FALSE(check_direction({2e-9, 0, 0}, kLimits, "/up"));
    EXPECT_TRUE(is_refused(check_direction({}, kLimits, "/up"), ErrorCode::kDegenerate, "/up"));
    EXPECT_TRUE(is_refused(check_direction({0, 5e-10, 0}, kLimits, "/up"), ErrorCode::kDegenerate, "/up"));
    EXPECT_TRUE(is_refused(check_direction({0, 1e-200, 0}, kLimits, "/up"), ErrorCode::kDegenerate, "/up"));
    EXPECT_TRUE(is_refused(check_direction({0, kNaN, 0}, kLimits, "/up"), ErrorCode::kNotFinite, "/up/1"));
}

TEST(CheckNotParallel, RefusesBothWaysAndIgnoresLengths) {
    const std::string field = "/wind";
    EXPECT_FALSE(check_not_parallel({1, 0, 0}, {0, 5, 0}, field, "up"));
    EXPECT_FALSE(check_not_parallel({1, 1e-5, 0}, {1, 0, 0}, field, "up"));
    EXPECT_TRUE(is_refused(check_not_parallel({1, 0, 0}, {1e6, 0, 0}, field, "up"), ErrorCode::kDegenerate, field));
    EXPECT_TRUE(is_refused(check_not_parallel({1, 0, 0}, {-1e-8, 0, 0}, field, "up"), ErrorCode::kDegenerate, field));
    EXPECT_TRUE(is_refused(check_not_parallel({1, 1e-7, 0}, {1, 0, 0}, field, "up"), ErrorCode::kDegenerate, field));
    EXPECT_EQ(check_not_parallel({1, 0, 0}, {1, 0, 0}, field, "up")->allowed, "a direction not parallel to up");
}

}  // namespace
}  // namespace tuftwave
