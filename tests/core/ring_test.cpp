#include "tuftwave/ring.hpp"

#include <gtest/gtest.h>

#include <cstddef>

namespace tuftwave {
namespace {

/// Of which no two numbers are the same.
Ring ring(const double first) {
    const auto vector = [&](double from) { return Vec3{first + from, first + from + 1, first + from + 2}; };
    return {{vector(0), vector(3), vector(6)}, first + 9, first + 10, first + 11};
}

void expect_same(const Ring& a, const Ring& b) {
    EXPECT_EQ(a.frame.point, b.frame.point);
    EXPECT_EQ(a.frame.tangent, b.frame.tangent);
    EXPECT_EQ(a.frame.normal, b.frame.normal);
    EXPECT_EQ(a.along, b.along);
    EXPECT_EQ(a.half_width, b.half_width);
    EXPECT_EQ(a.half_thickness, b.half_thickness);
}

TEST(Rings, AreThoseThatWereSet) {
    constexpr std::size_t kCount = 5;
    Rings rings(kCount);
    for (std::size_t i = kCount; i-- > 0;) rings.set(i, ring(20.0 * static_cast<double>(i)));
    ASSERT_EQ(rings.size(), kCount);
    for (std::size_t i = 0; i < kCount; ++i) expect_same(rings[i], ring(20.0 * static_cast<double>(i)));
}

TEST(Rings, OfOneQuantityAreSideBySide) {
    Rings rings(3);
    for (std::size_t i = 0; i < 3; ++i) {
        rings.frames().set(i, ring(static_cast<double>(i)).frame);
        rings.along()[i] = 0.25 * static_cast<double>(i);
        rings.half_widths()[i] = 0.5;
    }
    rings.frames().set_normal(1, {7, 8, 9});
    EXPECT_EQ(rings[1].frame.normal, (Vec3{7, 8, 9}));
    EXPECT_EQ(rings[1].frame.point, (Vec3{1, 2, 3}));
    EXPECT_EQ(rings[2].along, 0.5);
    EXPECT_EQ(rings[2].half_width, 0.5);
    EXPECT_EQ(rings[2].half_thickness, 0);
}

TEST(Rings, AreNoneAtFirst) {
    EXPECT_TRUE(Rings().empty());
    EXPECT_FALSE(Rings(1).empty());
}

}  // namespace
}  // namespace tuftwave
