#include "tuftwave/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>

namespace tuftwave {
namespace {

using Words = std::array<std::uint32_t, 4>;

constexpr std::uint32_t kAllOnes = 0xffffffff;

// The known answers that the authors publish with their library Random123, for philox4x32 with ten rounds.
TEST(Random, PhiloxGivesTheKnownAnswerForZeros) {
    EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
}

TEST(Random, PhiloxGivesTheKnownAnswerForOnes) {
    EXPECT_EQ(philox4x32({kAllOnes, kAllOnes, kAllOnes, kAllOnes}, {kAllOnes, kAllOnes}),
              (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
}

TEST(Random, PhiloxGivesTheKnownAnswerForTheDigitsOfPi) {
    EXPECT_EQ(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
              (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Random, EveryWordOfCounterAndKeyChangesTheWords) {
    std::set<Words> seen{philox4x32({0, 0, 0, 0}, {0, 0})};
    for (std::size_t i = 0; i < 4; ++i) {
        Words counter{};
        counter[i] = 1;
        EXPECT_TRUE(seen.insert(philox4x32(counter, {0, 0})).second) << "counter word " << i;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        std::array<std::uint32_t, 2> key{};
        key[i] = 1;
        EXPECT_TRUE(seen.insert(philox4x32({0, 0, 0, 0}, key)).second) << "key word " << i;
    }
}

TEST(Random, UnitIntervalReachesFromZeroToJustBelowOne) {
    EXPECT_EQ(unit_interval(0, 0), 0);
    EXPECT_EQ(unit_interval(0x80000000, 0), 0.5);
    EXPECT_EQ(unit_interval(kAllOnes, kAllOnes), 1 - 0x1p-53);
}

TEST(Random, UnitIntervalDropsTheLastElevenBitsOnly) {
    EXPECT_EQ(unit_interval(0, 0x7ff), 0);
    EXPECT_EQ(unit_interval(0, 0x800), 0x1p-53);
    EXPECT_EQ(unit_interval(1, 0), 0x1p-32);
}

TEST(Random, UnitIntervalIsSpreadEvenly) {
    // The mean of 100000 uniform numbers scatters by 1/sqrt(12 * 100000) = 0.0009; five times that is never seen.
    constexpr std::uint32_t kCount = 100000;
    double sum = 0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const Words words = philox4x32({i, 0, 0, 0}, {1, 2});
        sum += unit_interval(words[0], words[1]);
    }
    EXPECT_NEAR(sum / kCount, 0.5, 0.0045);
}

}  // namespace
}  // namespace tuftwave
