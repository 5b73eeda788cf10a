#include "tuftwave/wide.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace tuftwave {
namespace {

using Numbers = std::array<double, 37>;  // no multiple of any vector's width

TUFTWAVE_BODY void roots_of_sums(const Numbers& a, const Numbers& b, Numbers& out) {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::sqrt(a[i] * b[i] + a[i] / b[i]);
}

TEST(Wide, ABodyGivesTheSameBitsInBothWidths) {
    Numbers a, b, narrow{}, wide{};
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = 1.0 / static_cast<double>(i + 3);
        b[i] = std::sqrt(static_cast<double>(i + 2));
    }
    run_with<roots_of_sums>(Vectors::kNarrow, a, b, narrow);
    EXPECT_EQ(narrow[0], std::sqrt(a[0] * b[0] + a[0] / b[0]));
    if (!has_wide_vectors()) GTEST_SKIP() << "this CPU has no wide vectors";
    run_with<roots_of_sums>(Vectors::kWide, a, b, wide);
    EXPECT_EQ(narrow, wide);
}

TEST(Wide, TheWidestIsOneThatTheMachineRuns) {
    EXPECT_EQ(widest_vectors(), has_wide_vectors() ? Vectors::kWide : Vectors::kNarrow);
}

}  // namespace
}  // namespace tuftwave
