#include "tuftwave/wide.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace tuftwave {
namespace {

using Numbers = std::array<double, 37>;  // no multiple of any vector's width

TUFTWAVE_BODY void roots_of_sums(const Numbers& a, const Numbers& b, Numbers& out) {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::sqrt(a[i] * b[i] + a[i] / b[i]);
}

TEST(Wide, ABodyGivesTheSameBitsInEveryWidth) {
    Numbers a, b, expected{};
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = 1.0 / static_cast<double>(i + 3);
        b[i] = std::sqrt(static_cast<double>(i + 2));
        expected[i] = std::sqrt(a[i] * b[i] + a[i] / b[i]);
    }
    for (const Vectors vectors : usable_vectors()) {
        Numbers found{};
        run_with<roots_of_sums>(vectors, a, b, found);
        EXPECT_EQ(found, expected) << "of vectors " << static_cast<int>(vectors);
    }
}

TEST(Wide, TheWidestIsTheLastThatTheMachineRuns) {
    EXPECT_EQ(usable_vectors().front(), Vectors::kNarrow);
    EXPECT_TRUE(std::ranges::is_sorted(usable_vectors()));
    EXPECT_EQ(widest_vectors(), usable_vectors().back());
}

}  // namespace
}  // namespace tuftwave
