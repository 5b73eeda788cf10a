#include "tuftwave/curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "samples.hpp"
#include "support.hpp"
#include "tuftwave/ring.hpp"

namespace tuftwave {
namespace {

using test::are_near;
using test::Random;

std::vector<Vec3> circle(const int points, const double turns) {
    std::vector<Vec3> result;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * kPi * turns * i / (points - 1);
        result.push_back({0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.05});
    }
    return result;
}

std::vector<Vec3> random_walk(Random& random, const int points) {
    std::vector<Vec3> result{{}};
    for (int i = 1; i < points; ++i) result.push_back(result.back() + random.between(0.01, 0.05) * random.direction());
    return result;
}

/// Two points 133 times nearer to each other than the next two, the worst ratio in the drawn strokes.
std::vector<Vec3> uneven() { return {{0, 0, 0}, {0.1, 0.02, 0}, {0.10075, 0.0205, 0.0003}, {0.2, 0, 0.03}}; }

struct Stroke {
    std::string name;
    std::vector<Vec3> points;
};

/// The worst that the drawn strokes hold, and worse.
std::vector<Stroke> hard_strokes() {
    Random random(3);
    const Vec3 a{0.1, 0.2, 0.3}, b{0.15, 0.25, 0.2};
    std::vector<Stroke> strokes{{"two points", {a, b}},
                                {"uneven", uneven()},
                                {"1,193 degrees of turning", circle(18, 1193.0 / 360)},
                                {"coincident points", {a, a, b, b, b, {0.3, 0.2, 0.1}, {0.3, 0.2, 0.1}}},
                                {"there and back", {a, b, a}},
                                {"there and back twice", {a, b, a, b, a}},
                                {"almost there and back", {a, b, a + Vec3{1e-6, 0, 0}}},
                                {"closed", {a, b, {0.2, 0.1, 0.1}, a}},
                                {"1,024 points", random_walk(random, 1024)}};
    for (const Tuft& tuft : test::all_tufts()) strokes.push_back({tuft.name, tuft.points});
    std::vector<Vec3> far;  // neighbouring doubles, a million metres away
    for (double x = 1e6; far.size() < 12; x = std::nextafter(x, 2e6)) far.push_back({x, 0, 0});
    strokes.push_back({"neighbouring doubles", far});
    return strokes;
}

/// Where the curve passes nearest to a point, by a fine search.
double nearest_along(const Curve& curve, const Vec3& point) {
    constexpr int kSteps = 4000;
    const auto distance = [&](const double along) { return length(curve.at(along).point - point); };
    const double step = curve.arc_length() / kSteps;
    double best = 0;
    for (int i = 0; i <= kSteps; ++i) best = distance(i * step) < distance(best) ? i * step : best;
    double low = best - step, high = best + step;
    for (int i = 0; i < 100; ++i) {
        const double left = low + (high - low) / 3, right = high - (high - low) / 3;
        (distance(left) < distance(right) ? high : low) = distance(left) < distance(right) ? right : left;
    }
    return (low + high) / 2;
}

/// The length of the curve between two places, from inscribed polygons, extrapolated.
double polygon_length(const Curve& curve, const double from, const double to) {
    const auto polygon = [&](const int sides) {
        double sum = 0;
        Vec3 before = curve.at(from).point;
        for (int i = 1; i <= sides; ++i) {
            const Vec3 here = curve.at(from + (to - from) * i / sides).point;
            sum += length(here - before);
            before = here;
        }
        return sum;
    };
    const double coarse = polygon(1000), fine = polygon(2000);
    return fine + (fine - coarse) / 3;
}

TEST(Curve, PassesThroughEveryPoint) {
    for (const std::vector<Vec3>& points :
         {uneven(), circle(18, 1193.0 / 360), test::fringe().points, test::zigzag().points}) {
        const Curve curve(points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_TRUE(are_near(curve.at(nearest_along(curve, points[i])).point, points[i], 1e-12)) << "point " << i;
        }
        EXPECT_EQ(curve.at(0).point, points.front());
        EXPECT_EQ(curve.at(curve.arc_length()).point, points.back());
    }
}

TEST(Curve, ThroughTwoPointsIsAStraightLine) {
    const Vec3 a{0.1, 0.2, 0.3}, b{0.4, -0.2, 0.3};
    const Curve curve(std::vector<Vec3>{a, b});
    EXPECT_NEAR(curve.arc_length(), 0.5, 1e-15);
    EXPECT_NEAR(curve.turning_until(0.5), 0, 1e-15);
    for (int i = 0; i <= 10; ++i) EXPECT_TRUE(are_near(curve.at(0.05 * i).point, a + (i / 10.0) * (b - a), 1e-15));
}

TEST(Curve, ThroughPointsOnALineStaysOnIt) {
    const Curve curve(std::vector<Vec3>{{0, 1, 0}, {0.01, 1, 0}, {0.5, 1, 0}, {0.51, 1, 0}});
    EXPECT_NEAR(curve.arc_length(), 0.51, 1e-14);
    for (int i = 0; i <= 100; ++i) EXPECT_TRUE(are_near(curve.at(0.0051 * i).point, {0.0051 * i, 1, 0}, 1e-12)) << i;
}

TEST(Curve, ClampsToItsEnds) {
    const Curve curve(uneven());
    EXPECT_EQ(curve.at(-1).point, curve.at(0).point);
    EXPECT_EQ(curve.at(99).point, curve.at(curve.arc_length()).point);
}

// One piece of nine that was drawn to a point, as a curve once did at the end of each of its segments, is found here.
TEST(Curve, EqualStepsAreEquallyLong) {
    for (const std::vector<Vec3>& points : {uneven(), circle(18, 3), test::fringe().points, test::ponytail().points}) {
        const Curve curve(points);
        const double step = curve.arc_length() / 9;
        for (int i = 0; i < 9; ++i)
            EXPECT_NEAR(polygon_length(curve, i * step, (i + 1) * step), step, 1e-9 * step) << "step " << i;
    }
}

TEST(Curve, PointsDifferByNoMoreThanTheirDistanceAlong) {
    for (const Stroke& stroke : hard_strokes()) {
        const Curve curve(stroke.points);
        const double step = curve.arc_length() / 5000;
        for (int i = 0; i < 5000; ++i) {
            const double apart = length(curve.at((i + 1) * step).point - curve.at(i * step).point);
            ASSERT_LT(apart, 1.001 * step + 1e-9) << stroke.name << ", step " << i;
        }
    }
}

// Knots of 0.1 and 0.3, the roots of the distances, make it just 45 degrees; knots of equal size would make it 84, and
// the short piece would hook.
TEST(Curve, TangentsAreCentripetal) {
    const Vec3 corner{0.01, 0, 0};
    const Curve curve(std::vector<Vec3>{{}, corner, {0.01, 0.09, 0}});
    EXPECT_TRUE(are_near(curve.at(nearest_along(curve, corner)).tangent, normalized(Vec3{1, 1, 0}), 1e-9));
    EXPECT_TRUE(are_near(curve.at(0).tangent, {1, 0, 0}, 1e-15));  // the ends run along their chords
    EXPECT_TRUE(are_near(curve.at(1).tangent, {0, 1, 0}, 1e-15));
}

TEST(Curve, TangentIsTheDirectionOfTravel) {
    const Curve curve(uneven());
    const double h = 1e-5 * curve.arc_length();
    for (int i = 1; i < 500; ++i) {
        const double along = curve.arc_length() * i / 500;
        EXPECT_TRUE(
            are_near((curve.at(along + h).point - curve.at(along - h).point) / (2 * h), curve.at(along).tangent, 1e-3))
            << i;
    }
}

TEST(Curve, FramesAreOrthonormalOnEveryStroke) {
    for (const Stroke& stroke : hard_strokes()) {
        Curve curve(stroke.points);
        ASSERT_GT(curve.arc_length(), 0) << stroke.name;
        curve.face_away_from({0.01, 0.02, 0.03});
        for (int i = 0; i <= 2000; ++i) {
            const CurveFrame frame = curve.at(curve.arc_length() * i / 2000);
            ASSERT_TRUE(is_finite(frame.point)) << stroke.name << " " << i;
            ASSERT_NEAR(length(frame.tangent), 1, 1e-14) << stroke.name << " " << i;
            ASSERT_NEAR(length(frame.normal), 1, 1e-14) << stroke.name << " " << i;
            ASSERT_NEAR(dot(frame.tangent, frame.normal), 0, 1e-14) << stroke.name << " " << i;
            ASSERT_NEAR(length(frame.binormal()), 1, 1e-14) << stroke.name << " " << i;
        }
    }
}

TEST(Curve, NormalsDoNotSpinInAPlane) {
    const Curve curve(circle(18, 3));
    const double out_of_plane = curve.at(0).normal.z;
    for (int i = 0; i <= 1000; ++i)
        EXPECT_NEAR(curve.at(curve.arc_length() * i / 1000).normal.z, out_of_plane, 1e-12) << i;
}

TEST(Curve, NormalsAreThoseOfAFineIntegration) {
    constexpr int kSteps = 200'000;
    const Curve curve(test::ringlet(0.03).points);
    Vec3 normal = curve.at(0).normal;
    for (int i = 1; i <= kSteps; ++i) {
        const CurveFrame frame = curve.at(curve.arc_length() * i / kSteps);
        normal = normalized(rejected(normal, frame.tangent));
        if (i % 1000 != 0) continue;
        ASSERT_TRUE(are_near(normal, frame.normal, 1e-3)) << "step " << i;  // 1e-3: a twentieth of a degree
    }
}

// Near a sample, the step from it is no longer than its rounding, and may point anywhere. Axis-parallel lines show it:
// there the rounding can be exactly across the line.
TEST(Curve, NormalsStayTheSameARoundingAwayFromAPoint) {
    Random random(1);
    for (int i = 0; i < 50; ++i) {
        const Vec3 root = random.in_cube(1);
        std::vector<Vec3> points;
        for (int k = 0; k < 4; ++k) points.push_back(root + Vec3{0.1 * k + random.between(0, 0.03), 0, 0});
        const Curve curve(points);
        const Vec3 normal = curve.at(0.01).normal;
        for (int k = 0; k < 4000; ++k) {
            const double place = points[static_cast<std::size_t>(k % 4)].x - points[0].x;
            const double along = place + random.between(-1, 1) * std::pow(10, random.between(-17, -10));
            ASSERT_TRUE(are_near(curve.at(along).normal, normal, 1e-9)) << "seed 1, line " << i << ", along " << along;
        }
    }
}

TEST(Curve, AnswersDoNotDependOnTheOrderOfQuestions) {
    const Curve curve(test::ponytail().points), other(test::ponytail().points);
    std::vector<CurveFrame> forwards, backwards;
    for (int i = 0; i <= 100; ++i) forwards.push_back(curve.at(curve.arc_length() * i / 100));
    for (int i = 100; i >= 0; --i) backwards.push_back(other.at(other.arc_length() * i / 100));
    for (std::size_t i = 0; i <= 100; ++i) {
        EXPECT_EQ(forwards[i].point, backwards[100 - i].point) << i;
        EXPECT_EQ(forwards[i].normal, backwards[100 - i].normal) << i;
    }
}

TEST(Curve, TurningNeverFallsAndIsTheArcsAngle) {
    const Curve curve(circle(64, 0.75));
    double before = 0;
    for (int i = 0; i <= 1000; ++i) {
        const double turning = curve.turning_until(curve.arc_length() * i / 1000);
        EXPECT_GE(turning, before) << i;
        before = turning;
    }
    EXPECT_NEAR(before, 1.5 * kPi, 0.02 * kPi);
}

double along_at(const Curve& curve, double part, double turn_worth) {
    double along = 0;
    Rings ring(1);
    curve.at_parts({&part, 1}, turn_worth, {&along, 1}, ring.frames());
    return along;
}

TEST(Curve, EqualPartsOfLengthAndTurningAreShorterInBends) {
    const Curve curve(test::hairpin().points);  // its bend lies in the middle
    const double whole = curve.arc_length();
    EXPECT_NEAR(along_at(curve, 0.3, 0), 0.3 * whole, 1e-12);
    double before = 0;
    for (int i = 0; i <= 20; ++i) {
        const double along = along_at(curve, i / 20.0, 0.1);
        EXPECT_GE(along, before) << i;
        before = along;
    }
    EXPECT_LT(along_at(curve, 0.55, 0.1) - along_at(curve, 0.45, 0.1), 0.05 * whole);
}

TEST(Curve, ManyPartsAreThoseOfEachInAnyOrder) {
    const Curve curve(test::hairpin().points);
    const std::vector<double> parts{0.5, 0.1, 0, 0.45, 0.451, 1, 0.999, 0.3};
    std::vector<double> along(parts.size());
    Rings rings(parts.size());
    curve.at_parts(parts, 0.1, along, rings.frames());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        EXPECT_EQ(along[i], along_at(curve, parts[i], 0.1)) << parts[i];
        EXPECT_TRUE(are_near(rings[i].frame.point, curve.at(along[i]).point, 1e-15)) << parts[i];
        EXPECT_TRUE(are_near(rings[i].frame.normal, curve.at(along[i]).normal, 1e-15)) << parts[i];
    }
}

// A rounding beyond the end would be past the tip, where a tuft has no width.
TEST(Curve, PartsEndJustAtTheEnd) {
    Random random(6);
    for (int i = 0; i < 2000; ++i) {
        const Curve curve(random_walk(random, 5));
        EXPECT_EQ(along_at(curve, 0, 0.1), 0) << "seed 6, curve " << i;
        EXPECT_EQ(along_at(curve, 1, random.between(0, 1)), curve.arc_length()) << "seed 6, curve " << i;
    }
}

TEST(Curve, FacesAwayFromTheHead) {
    std::vector<Vec3> meridian;  // over the head from front to back
    for (int i = 0; i <= 10; ++i) {
        const double angle = kPi * (0.2 + 0.06 * i);
        meridian.push_back({0, 0.1 * std::sin(angle), 0.1 * std::cos(angle)});
    }
    Curve curve(meridian);
    curve.face_away_from({});
    for (int i = 0; i <= 100; ++i) {
        const CurveFrame frame = curve.at(curve.arc_length() * i / 100);
        EXPECT_TRUE(are_near(frame.normal, normalized(frame.point), 0.1)) << i;  // the ends are chords
    }
}

TEST(Curve, FacingAwayTurnsEveryNormalByTheSameAngle) {
    const Curve before(test::ponytail().points);
    Curve after = before;
    after.face_away_from({0, 0, 0.01});
    const auto turn_at = [&](const double along) {
        const CurveFrame old = before.at(along);
        const Vec3 normal = after.at(along).normal;
        return std::atan2(dot(normal, old.binormal()), dot(normal, old.normal));
    };
    for (int i = 1; i <= 100; ++i) EXPECT_NEAR(turn_at(before.arc_length() * i / 100), turn_at(0), 1e-12) << i;
}

TEST(Curve, FacingAwayFromItsOwnLineChangesNothing) {
    Curve curve(std::vector<Vec3>{{0, 0.1, 0}, {0, 0.2, 0}});
    const Vec3 normal = curve.at(0).normal;
    curve.face_away_from({});
    EXPECT_EQ(curve.at(0).normal, normal);
}

}  // namespace
}  // namespace tuftwave
