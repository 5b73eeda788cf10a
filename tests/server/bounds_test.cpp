#include "gltf/bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace tuftwave::server::gltf {
namespace {

TEST(Bounds, FindTheLeastAndTheMostWhereverTheyStand) {
    for (std::size_t points = 1; points <= 30; ++points) {
        for (std::size_t outlier = 0; outlier < points; ++outlier) {
            std::vector<float> numbers;
            for (std::size_t i = 0; i < points; ++i) {
                const auto x = static_cast<float>(i % 5);
                numbers.insert(numbers.end(), {x, 10 - x, 7});
            }
            numbers[3 * outlier] = -1;
            numbers[3 * outlier + 2] = 8;
            const Bounds bounds = bounds_of(numbers);
            EXPECT_EQ(bounds.least[0], -1) << points;
            EXPECT_EQ(bounds.most[1], 10) << points;
            EXPECT_EQ(bounds.least[2], points == 1 ? 8 : 7) << points;
            EXPECT_EQ(bounds.most[2], 8) << points;
        }
    }
}

TEST(Bounds, HaveOneZero) {
    const Bounds bounds = bounds_of(std::vector<float>{-0.0F, 0, -1, 0, -0.0F, 1});
    for (const float zero : {bounds.least[0], bounds.most[0], bounds.least[1], bounds.most[1]})
        EXPECT_FALSE(std::signbit(zero));
}

TEST(Bounds, TakeOthersIn) {
    Bounds bounds{{0, 0, 0}, {1, 1, 1}};
    bounds.include({{-1, 0.5F, 0.5F}, {0.5F, 2, 0.5F}});
    EXPECT_EQ(bounds.least, (std::array<float, 3>{-1, 0, 0}));
    EXPECT_EQ(bounds.most, (std::array<float, 3>{1, 2, 1}));
}

}  // namespace
}  // namespace tuftwave::server::gltf
