#include "tuftwave/math.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>

namespace tuftwave {
namespace {

constexpr int kSamples = 10000;
constexpr std::uint64_t kSeed = 7;
constexpr double kRounding = 5e-15;  // some dozens of roundings of numbers of size 1, at 1.1e-16 each
constexpr Vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

/// Random directions and turns from raw bits: standard distributions differ between libraries. Never ask for two
/// within one expression: compilers differ in which comes first.
class Directions {
  public:
    double uniform(const double low, const double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    Vec3 unit() {
        for (;;) {
            const Vec3 v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
            if (const double l = length(v); l > 0.1 && l < 1) return v / l;
        }
    }
    Quat turn() {
        const Vec3 axis = unit();
        return turn_about(axis, uniform(-kPi, kPi));
    }

  private:
    std::mt19937_64 engine_{kSeed};
};

double distance(const Vec3& a, const Vec3& b) { return length(a - b); }

/// Distance between two turns, of which each has two quaternions.
double distance(const Quat& a, const Quat& b) {
    const double sign = dot(a, b) < 0 ? -1 : 1;
    const Quat d{a.x - sign * b.x, a.y - sign * b.y, a.z - sign * b.z, a.w - sign * b.w};
    return std::sqrt(dot(d, d));
}

TEST(Math, AnyPerpendicularIsUnitAndPerpendicular) {
    Directions directions;
    for (int i = 0; i < kSamples; ++i) {
        const Vec3 a = directions.unit(), b = any_perpendicular(a);
        ASSERT_NEAR(dot(a, b), 0, kRounding) << "seed " << kSeed << ", sample " << i;
        ASSERT_NEAR(length(b), 1, kRounding) << "seed " << kSeed << ", sample " << i;
        ASSERT_EQ(b, any_perpendicular(a));
    }
    for (const Vec3& axis : {kX, kY, kZ, -kX, -kY, -kZ}) {
        EXPECT_EQ(dot(axis, any_perpendicular(axis)), 0);
        EXPECT_EQ(length(any_perpendicular(axis)), 1);
    }
}

TEST(Math, NormalizedQuaternionIsUnitAndPointsTheSameWay) {
    const Quat q = normalized(Quat{1, -2, 2, -4});
    EXPECT_EQ(q, (Quat{0.2, -0.4, 0.4, -0.8}));
}

TEST(Math, RotationKeepsLengthsAndItsInverseUndoesIt) {
    Directions directions;
    for (int i = 0; i < kSamples; ++i) {
        const Quat q = directions.turn();
        const Vec3 v = directions.unit();
        ASSERT_NEAR(dot(q, q), 1, kRounding) << "seed " << kSeed << ", sample " << i;
        ASSERT_NEAR(length(rotated(q, v)), length(v), kRounding) << "seed " << kSeed << ", sample " << i;
        ASSERT_LT(distance(rotated(inverse(q), rotated(q, v)), v), kRounding) << "seed " << kSeed << ", sample " << i;
        ASSERT_LT(distance(rotated(-q, v), rotated(q, v)), kRounding) << "seed " << kSeed << ", sample " << i;
    }
}

TEST(Math, ProductRotatesByTheRightFactorFirst) {
    Directions directions;
    for (int i = 0; i < kSamples; ++i) {
        const Quat a = directions.turn(), b = directions.turn();
        const Vec3 v = directions.unit();
        ASSERT_LT(distance(rotated(a * b, v), rotated(a, rotated(b, v))), 2 * kRounding)
            << "seed " << kSeed << ", sample " << i;
    }
}

TEST(Math, TurnAboutIsCounterClockwiseSeenFromTheTip) {
    EXPECT_EQ(turn_about(kY, 0), Quat{});
    EXPECT_LT(distance(rotated(turn_about(kZ, kPi / 2), kX), kY), kRounding);
    EXPECT_LT(distance(rotated(turn_about(kX, kPi / 2), kY), kZ), kRounding);
    EXPECT_LT(distance(rotated(turn_about(kY, kPi / 2), kZ), kX), kRounding);
    EXPECT_LT(distance(rotated(turn_about(kZ, kPi / 3), kX), {0.5, std::sqrt(0.75), 0}), kRounding);
}

TEST(Math, ShortestTurnTakesFromToTo) {
    Directions directions;
    for (int i = 0; i < kSamples; ++i) {
        const Vec3 from = directions.unit(), to = directions.unit();
        const Quat turn = shortest_turn(from, to, any_perpendicular(from));
        ASSERT_NEAR(dot(turn, turn), 1, kRounding) << "seed " << kSeed << ", sample " << i;
        ASSERT_LT(distance(rotated(turn, from), to), kRounding) << "seed " << kSeed << ", sample " << i;
        // Shortest: the axis is perpendicular to both, so neither is twisted about itself.
        const Vec3 axis{turn.x, turn.y, turn.z};
        ASSERT_NEAR(dot(axis, from), 0, kRounding) << "seed " << kSeed << ", sample " << i;
        ASSERT_GE(turn.w, 0) << "seed " << kSeed << ", sample " << i;
    }
}

TEST(Math, ShortestTurnSharesOfATurnAddUpToIt) {
    Directions directions;
    for (int i = 0; i < kSamples; ++i) {
        const Vec3 from = directions.unit(), to = directions.unit();
        const double part = directions.uniform(0, 1);
        const Vec3 side = any_perpendicular(from);
        const Quat whole = shortest_turn(from, to, side);
        const Quat sum = shortest_turn(from, to, side, 1 - part) * shortest_turn(from, to, side, part);
        ASSERT_LT(distance(sum, whole), kRounding) << "seed " << kSeed << ", sample " << i;
    }
    EXPECT_EQ(shortest_turn(kX, kY, kZ, 0), Quat{});
    EXPECT_LT(distance(shortest_turn(kX, kY, kZ, 0.5), turn_about(kZ, kPi / 4)), kRounding);
}

TEST(Math, ShortestTurnOfEqualDirectionsIsExactlyNone) {
    Directions directions;
    for (int i = 0; i < kSamples; ++i) {
        const Vec3 from = directions.unit();
        ASSERT_EQ(shortest_turn(from, from, any_perpendicular(from)), Quat{}) << "seed " << kSeed << ", sample " << i;
        ASSERT_EQ(shortest_turn(from, from, any_perpendicular(from), 0.5), Quat{}) << "sample " << i;
    }
}

TEST(Math, ShortestTurnKeepsAllDigitsOfASmallAngle) {
    // To the last digits of the angle itself, not only to 1e-16 of a whole turn.
    for (const double angle : {1e-3, 1e-8, 1e-15, 1e-30, 1e-90}) {
        const Vec3 to = normalized(Vec3{1, std::tan(angle), 0});
        EXPECT_NEAR(shortest_turn(kX, to, kZ).z / std::sin(angle / 2), 1, kRounding) << angle;
        EXPECT_NEAR(shortest_turn(kX, to, kZ, 0.5).z / std::sin(angle / 4), 1, kRounding) << angle;
    }
}

TEST(Math, ShortestTurnByAVanishingAngleIsUnit) {
    // The squares of these angles are subnormal or 0, so an axis found by dividing by a length would not be one.
    for (const double angle : {1e-150, 1e-160, 1e-300, 5e-324}) {
        EXPECT_EQ(shortest_turn(kX, {1, angle, 0}, kZ), (Quat{0, 0, angle / 2, 1})) << angle;
        EXPECT_EQ(shortest_turn(kX, {1, angle, 0}, kZ, 0.5), Quat{}) << angle;
    }
}

TEST(Math, ShortestTurnOfOppositeDirectionsTurnsAboutTheGivenAxis) {
    Directions directions;
    for (int i = 0; i < kSamples; ++i) {
        const Vec3 from = directions.unit(), axis = any_perpendicular(from);
        const Quat whole = shortest_turn(from, -from, axis);
        ASSERT_LT(distance(rotated(whole, from), -from), kRounding) << "seed " << kSeed << ", sample " << i;
        ASSERT_LT(distance(rotated(whole, axis), axis), kRounding) << "seed " << kSeed << ", sample " << i;
        const Quat half = shortest_turn(from, -from, axis, 0.5);
        ASSERT_LT(distance(rotated(half, from), cross(axis, from)), kRounding) << "seed " << kSeed << ", sample " << i;
    }
}

TEST(Math, ShortestTurnOfNearlyOppositeDirectionsStillArrives) {
    Directions directions;
    for (const double rest : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-16, 1e-200}) {
        // Below a nanometre on a metre the given axis is used, and the turn ends that far beside its aim.
        const double allowed = rest < 1e-9 ? rest + kRounding : kRounding;
        for (int i = 0; i < 100; ++i) {
            const Vec3 from = directions.unit(), side = any_perpendicular(from);
            const Vec3 to = normalized(rest * cross(from, side) - from);
            const Quat turn = shortest_turn(from, to, side);
            ASSERT_NEAR(dot(turn, turn), 1, kRounding) << "rest " << rest << ", sample " << i;
            ASSERT_LT(distance(rotated(turn, from), to), allowed) << "rest " << rest << ", sample " << i;
        }
    }
}

TEST(Math, RotationFromAxesRecoversTheAxes) {
    Directions directions;
    for (int i = 0; i < kSamples; ++i) {
        const Quat q = directions.turn();
        const Vec3 x = rotated(q, kX), y = rotated(q, kY), z = rotated(q, kZ);
        const Quat found = rotation_from_axes(x, y, z);
        ASSERT_NEAR(dot(found, found), 1, kRounding) << "seed " << kSeed << ", sample " << i;
        ASSERT_LT(distance(found, q), kRounding) << "seed " << kSeed << ", sample " << i;
    }
}

TEST(Math, RotationFromAxesIsExactForTheTwentyFourTurnsOfACube) {
    // Half turns have no w and quarter turns tie between branches: the cases in which a careless formula divides by 0.
    const std::array<Vec3, 6> axes{kX, kY, kZ, -kX, -kY, -kZ};
    int turns = 0;
    for (const Vec3& x : axes) {
        for (const Vec3& y : axes) {
            if (dot(x, y) != 0) continue;
            const Vec3 z = cross(x, y);
            const Quat q = rotation_from_axes(x, y, z);
            EXPECT_LT(distance(rotated(q, kX), x), kRounding);
            EXPECT_LT(distance(rotated(q, kY), y), kRounding);
            EXPECT_LT(distance(rotated(q, kZ), z), kRounding);
            ++turns;
        }
    }
    EXPECT_EQ(turns, 24);
    EXPECT_EQ(rotation_from_axes(kX, kY, kZ), Quat{});
}

/// The product a * b of column-major 4x4 matrices.
std::array<double, 16> product(const std::array<double, 16>& a, const std::array<double, 16>& b) {
    std::array<double, 16> c{};
    for (std::size_t column = 0; column < 4; ++column) {
        for (std::size_t row = 0; row < 4; ++row) {
            for (std::size_t k = 0; k < 4; ++k) c[4 * column + row] += a[4 * k + row] * b[4 * column + k];
        }
    }
    return c;
}

TEST(Math, InverseRigidMatrixTimesTheMatrixIsTheIdentity) {
    constexpr std::array<double, 16> kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    Directions directions;
    for (int i = 0; i < kSamples; ++i) {
        const Quat q = directions.turn();
        const Vec3 origin = directions.unit();
        const Vec3 x = rotated(q, kX), y = rotated(q, kY), z = rotated(q, kZ);
        const std::array<double, 16> matrix{x.x, x.y, x.z, 0, y.x,      y.y,      y.z,      0,
                                            z.x, z.y, z.z, 0, origin.x, origin.y, origin.z, 1};
        const std::array<double, 16> found = product(inverse_rigid_matrix(q, origin), matrix);
        const auto first_off = std::mismatch(found.begin(), found.end(), kIdentity.begin(), [](double a, double b) {
                                   return std::abs(a - b) < kRounding;
                               }).first;
        ASSERT_EQ(first_off, found.end()) << "seed " << kSeed << ", sample " << i << ": entry "
                                          << std::distance(found.begin(), first_off) << " is " << *first_off;
    }
}

TEST(Math, InverseRigidMatrixOfAMoveMovesBack) {
    EXPECT_EQ(inverse_rigid_matrix(Quat{}, {1, 2, 3}),
              (std::array<double, 16>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, -2, -3, 1}));
}

}  // namespace
}  // namespace tuftwave
