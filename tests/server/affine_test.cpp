#include "character/affine.hpp"

#include <gtest/gtest.h>

#include "tuftwave/elementary.hpp"

namespace tuftwave::server::character {
namespace {

constexpr double kClose = 1e-12;

void expect_near(const Vec3& a, const Vec3& b, double tolerance = kClose) {
    EXPECT_LT(length(a - b), tolerance) << a.x << " " << a.y << " " << a.z << ", not " << b.x << " " << b.y << " "
                                        << b.z;
}

const Placement kPlaces[] = {{},
                             {{1, 2, 3}, turn_about({0, 0, 1}, 0.5), {1, 1, 1}},
                             {{-1, 0, 2}, turn_about({1, 0, 0}, kPi), {2, 3, 4}},  // half a turn: the trace is least
                             {{0, 0, 0}, turn_about({0, 1, 0}, -kPi), {0.01, 0.01, 0.01}},
                             {{0, 0, 0}, turn_about({0, 0, 1}, kPi - 1e-6), {1, 1, 100}},
                             {{5, 0, 0}, normalized(Quat{1, -2, 3, -4}), {1e-3, 1, 1e3}}};

TEST(Affine, OfAPlacementScalesThenTurnsThenMoves) {
    const Affine a = to_affine({{1, 2, 3}, turn_about({0, 0, 1}, kPi / 2), {2, 1, 1}});
    expect_near(transformed(a, {1, 0, 0}), {1, 4, 3});
    expect_near(transformed(a, {0, 1, 0}), {0, 2, 3});
}

TEST(Affine, ProductIsTheSecondThenTheFirst) {
    for (const Placement& first : kPlaces) {
        for (const Placement& second : kPlaces) {
            const Affine a = to_affine(first), b = to_affine(second);
            const Vec3 point{0.3, -0.7, 0.2};
            expect_near(transformed(a * b, point), transformed(a, transformed(b, point)), 1e-9);
        }
    }
}

TEST(Affine, IsTakenApartAgain) {
    for (const Placement& placement : kPlaces) {
        const auto found = to_placement(to_affine(placement));
        ASSERT_TRUE(found);
        expect_near(found->translation, placement.translation);
        expect_near(found->scale, placement.scale, 1e-9);
        EXPECT_NEAR(std::abs(dot(found->rotation, placement.rotation)), 1, 1e-9);
        EXPECT_NEAR(dot(found->rotation, found->rotation), 1, kClose);
    }
}

TEST(Affine, ThatMirrorsShearsOrFlattensHasNoPlacement) {
    const Affine mirrored{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}};
    const Affine upside_down{{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {}};
    const Affine sheared{{1, 0, 0}, {0.01, 1, 0}, {0, 0, 1}, {}};
    const Affine flat{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {}};
    for (const Affine& a : {mirrored, upside_down, sheared, flat}) EXPECT_FALSE(to_placement(a));
}

TEST(Affine, ThatIsSquareButForRoundingHasAPlacement) {
    const auto found = to_placement({{1, 0, 0}, {1e-5, 1, 0}, {0, 0, 1}, {}});
    ASSERT_TRUE(found);
    EXPECT_NEAR(dot(found->rotation, found->rotation), 1, kClose);
}

}  // namespace
}  // namespace tuftwave::server::character
