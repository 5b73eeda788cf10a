#include "poses/euler.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace tuftwave::server::poses {
namespace {

Quat composed(const ZxyAngles& angles) {
    return turn_about({0, 0, 1}, angles.z) * turn_about({1, 0, 0}, angles.x) * turn_about({0, 1, 0}, angles.y);
}

TEST(Euler, AnglesMakeTheRotationAgain) {
    for (int i = 0; i < 1'000; ++i) {  // all around: the four parts have periods that share no factor
        const Quat q =
            normalized(Quat{std::sin(0.7 * i), std::sin(1.1 * i + 1), std::cos(1.3 * i), std::cos(0.3 * i + 2)});
        EXPECT_NEAR(std::abs(dot(composed(zxy_angles(q)), q)), 1, 1e-15) << i;
    }
}

TEST(Euler, ArePreciseAtThePolesToo) {
    for (const double side : {-1.0, 1.0}) {
        for (const double off : {0.0, 1e-17, 1e-12, 1e-9, 1e-8, 1e-6, 1e-3}) {
            for (const double z : {-3.0, 0.4, 2.0}) {
                const Quat q = composed({z, side * (kPi / 2 - off), 1.1});
                const ZxyAngles angles = zxy_angles(q);
                const Quat rest = inverse(q) * composed(angles);
                EXPECT_LT(length(Vec3{rest.x, rest.y, rest.z}), 1e-15) << side << ", " << off << ", " << z;
                EXPECT_LE(std::abs(angles.x), kPi / 2);
            }
        }
    }
}

TEST(Euler, NoRotationIsThreeZeros) {
    const ZxyAngles none = zxy_angles({});
    EXPECT_EQ(none.z, 0);
    EXPECT_EQ(none.x, 0);
    EXPECT_EQ(none.y, 0);
}

}  // namespace
}  // namespace tuftwave::server::poses
