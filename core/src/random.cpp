// Based on: J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw. Parallel random numbers: as easy as 1, 2, 3. 2011.
//           Section 3.3, Philox4x32 with ten rounds.
#include "tuftwave/random.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace tuftwave {
namespace {

constexpr int kRounds = 10;
constexpr std::array<std::uint64_t, 2> kMultipliers{0xD2511F53, 0xCD9E8D57};
// What the key grows by every round: the golden ratio less 1 and the square root of 3 less 1, times 2^32.
constexpr std::array<std::uint32_t, 2> kWeyl{0x9E3779B9, 0xBB67AE85};

constexpr std::uint32_t high_word(const std::uint64_t product) { return static_cast<std::uint32_t>(product >> 32); }
constexpr std::uint32_t low_word(const std::uint64_t product) { return static_cast<std::uint32_t>(product); }

}  // namespace

std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
    for (int round = 0; round < kRounds; ++round) {
        const std::uint64_t first = kMultipliers[0] * counter[0];
        const std::uint64_t second = kMultipliers[1] * counter[2];
        counter = {high_word(second) ^ counter[1] ^ key[0], low_word(second), high_word(first) ^ counter[3] ^ key[1],
                   low_word(first)};
        for (std::size_t i = 0; i < key.size(); ++i) key[i] += kWeyl[i];
    }
    return counter;
}

double unit_interval(const std::uint32_t first, const std::uint32_t second) {
    const std::uint64_t bits = (std::uint64_t{first} << 32 | second) >> 11;
    return static_cast<double>(bits) * 0x1p-53;
}

}  // namespace tuftwave
