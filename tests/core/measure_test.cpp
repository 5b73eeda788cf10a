#include "tuftwave/measure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support.hpp"

namespace tuftwave {
namespace {

using test::is_refused;

// Two segments in two pictures are the smallest in which segments, nodes and pictures are all averaged.
const std::vector<Line> kLines{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}};

std::vector<Line> moved(std::vector<Line> lines, const Vec3& by) {
    for (Line& line : lines) {
        for (Vec3& node : line) node = node + by;
    }
    return lines;
}

TEST(MeasureError, OfAMotionWithItselfIsNone) {
    const MotionError error = *measure_error(kLines, kLines, 2);
    EXPECT_EQ(error.mean.angle, 0);
    EXPECT_EQ(error.mean.position, 0);
    EXPECT_EQ(error.pictures.size(), 2u);
}

TEST(MeasureError, DoesNotCareWhereTheRootIs) {
    EXPECT_NEAR(measure_error(moved(kLines, {3, -4, 5}), kLines, 2)->mean.position, 0, 1e-15);
}

TEST(MeasureError, AveragesSegmentsNodesAndPictures) {
    // Against a straight line the second picture's second segment is off by 90 degrees, its tip by the square root
    // of 2.
    const std::vector<Line> straight(2, kLines[0]);
    const MotionError error = *measure_error(kLines, straight, 2);
    EXPECT_EQ(error.pictures[0].angle, 0);
    EXPECT_NEAR(error.pictures[1].angle, kPi / 4, 1e-15);
    EXPECT_NEAR(error.pictures[1].position, std::sqrt(2) / 2 / 2, 1e-15);
    EXPECT_NEAR(error.mean.angle, kPi / 8, 1e-15);
    EXPECT_NEAR(error.mean.position, std::sqrt(2) / 8, 1e-15);
}

TEST(MeasureError, IsTheSameFromBothSidesAndInAnyUnit) {
    const std::vector<Line> straight(2, kLines[0]);
    const LineError there = measure_error(kLines, straight, 2)->mean, back = measure_error(straight, kLines, 2)->mean;
    EXPECT_EQ(there.angle, back.angle);
    EXPECT_EQ(there.position, back.position);
    std::vector<Line> large = kLines, large_straight = straight;
    for (std::vector<Line>* lines : {&large, &large_straight}) {
        for (Line& line : *lines) {
            for (Vec3& node : line) node = 1024 * node;
        }
    }
    EXPECT_EQ(measure_error(large, large_straight, 2048)->mean.position, there.position);
}

TEST(MeasureError, OfAReversedSegmentIsHalfATurn) {
    const std::vector<Line> right{{{0, 0, 0}, {1, 0, 0}}}, left{{{0, 0, 0}, {-1, 0, 0}}};
    EXPECT_DOUBLE_EQ(measure_error(right, left, 1)->mean.angle, kPi);
}

TEST(MeasureError, RefusesWhatDoesNotBelongTogether) {
    const std::vector<Line> one{kLines[0]}, short_line{kLines[0], {{0, 0, 0}, {1, 0, 0}}};
    EXPECT_TRUE(is_refused(measure_error(one, kLines, 2), ErrorCode::kConflict, ""));
    EXPECT_TRUE(is_refused(measure_error(short_line, kLines, 2), ErrorCode::kConflict, "/1"));
}

TEST(StillError, IsTheErrorOfTheMeanPicture) {
    // Two pictures that swing by the same angle to both sides: the mean hangs in the middle.
    const std::vector<Line> swing{{{0, 0, 0}, {0.6, -0.8, 0}}, {{0, 0, 0}, {-0.6, -0.8, 0}}};
    const MotionError error = still_error(moved(swing, {1, 1, 1}), 1);
    EXPECT_NEAR(error.mean.position, 0.6, 1e-15);
    EXPECT_NEAR(error.mean.angle, std::atan2(0.6, 0.8), 1e-15);
    EXPECT_EQ(still_error(std::vector<Line>(3, kLines[0]), 2).mean.angle, 0);
}

TEST(ErrorInAll, CountsEverySegmentOfEveryPictureTheSame) {
    // Three segments in one picture and one segment in two: of five, three are off by 1 and two by 6.
    const std::vector<MotionError> chains{{{1, 10}, {{1, 10}}}, {{6, 60}, {{6, 60}, {6, 60}}}};
    const std::vector<std::size_t> segments{3, 1};
    EXPECT_DOUBLE_EQ(error_in_all(chains, segments).angle, 3);
    EXPECT_DOUBLE_EQ(error_in_all(chains, segments).position, 30);
}

TEST(MeanLength, IsThatOfWholeChainsOverThePictures) {
    EXPECT_EQ(mean_length(kLines), 2);
    EXPECT_EQ(mean_length(std::vector<Line>{kLines[0], {{0, 0, 0}, {0, 0, 0}, {0, 0, 4}}}), 3);
}

TEST(CheckLines, AcceptsLinesOfAMotion) { EXPECT_FALSE(check_lines(kLines, {})); }

TEST(CheckLines, RefusesWithCodeAndField) {
    EXPECT_TRUE(is_refused(check_lines({}, {}), ErrorCode::kTooFew, ""));
    EXPECT_TRUE(is_refused(check_lines(std::vector<Line>(25, kLines[0]), {}), ErrorCode::kTooMany, ""));
    EXPECT_TRUE(is_refused(check_lines(std::vector<Line>{kLines[0], {{0, 0, 0}}}, {}), ErrorCode::kTooFew, "/1"));
    EXPECT_TRUE(
        is_refused(check_lines(std::vector<Line>{kLines[0], {{0, 0, 0}, {1, 0, 0}}}, {}), ErrorCode::kConflict, "/1"));
    std::vector<Line> wrong = kLines;
    wrong[1][2].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(is_refused(check_lines(wrong, {}), ErrorCode::kNotFinite, "/1/2/1"));
}

}  // namespace
}  // namespace tuftwave
