// Based on: R. Giulietti. The Schubfach way to render doubles. 2020. Section 8.
// Differs: exact products, since all powers of ten that a skeleton's numbers need are short; and what is so close to
// call that nlohmann's Grisu2, whose arithmetic is not exact, may find other digits is left to it.
#include "gltf/double_text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

namespace tuftwave::server::gltf {
namespace {

constexpr std::size_t kMostDigits = 17;

/// 5^0 to 5^26
constexpr auto kPowersOfFive = [] {
    std::array<std::uint64_t, 27> powers{1};
    for (std::size_t n = 1; n < powers.size(); ++n) powers[n] = 5 * powers[n - 1];
    return powers;
}();

/// A number of 128 bits.
struct Wide {
    std::uint64_t high, low;
};

Wide product_of(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t kHalf = 0xFFFFFFFF;
    const std::uint64_t first = (a & kHalf) * (b & kHalf);
    const std::uint64_t second = (a >> 32) * (b & kHalf) + (first >> 32);
    const std::uint64_t third = (a & kHalf) * (b >> 32) + (second & kHalf);
    return {(a >> 32) * (b >> 32) + (second >> 32) + (third >> 32), third << 32 | (first & kHalf)};
}

/// digits * 10^exponent
struct Decimal {
    std::uint64_t digits;
    int exponent;
};

Decimal without_zeros(Decimal decimal) {
    while (decimal.digits % 10 == 0) decimal = {decimal.digits / 10, decimal.exponent + 1};
    return decimal;
}

/// The digits that Grisu2 finds, if that is certain. @param value  > 0
std::optional<Decimal> shortest(double value) {
    // The double is c 2^e; whatever lies less than half way to its neighbours reads back as it.
    constexpr std::uint64_t kHidden = std::uint64_t{1} << 52;
    constexpr int kLeastExponent = -85;  // below, 20^-t is no number of 64 bits
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const std::uint64_t fraction = bits & (kHidden - 1), c = fraction | kHidden;
    const int e = static_cast<int>(bits >> 52) - 1075;
    if (e < kLeastExponent || e >= 0 || fraction == 0) return {};  // a power of two has a nearer neighbour
    // 10^-n is the largest power of ten that is no longer than the way to a neighbour. In units of 10^-n 2^-t, half
    // that way is 5^n long.
    const int n = -((e * 1262611) >> 22), t = 1 - e - n;
    const std::uint64_t half = kPowersOfFive[static_cast<std::size_t>(n)], one = std::uint64_t{1} << t;
    const Wide scaled = product_of(2 * c, half);
    const std::uint64_t whole = scaled.high << (64 - t) | scaled.low >> t, rest = scaled.low & (one - 1);

    const std::uint64_t unsure = half / 64;  // Grisu2's arithmetic is good to a part in 512
    const std::uint64_t below_tens = whole % 10 * one + rest, above_tens = 10 * one - below_tens;
    const std::uint64_t to_tens = std::min(below_tens, above_tens);
    if (to_tens + unsure < half) return without_zeros({whole / 10 + (above_tens < below_tens ? 1 : 0), 1 - n});
    const std::uint64_t above = one - rest, to_whole = std::min(rest, above);
    const bool is_close = to_tens <= half || to_whole + unsure >= half || one - 2 * to_whole <= unsure;
    if (is_close) return {};
    return Decimal{whole + (above < rest ? 1 : 0), -n};
}

}  // namespace

char* write_double(char* to, double value) {
    constexpr int kLeastPlace = -4, kMostPlace = 15;  // of the point, beyond which there is an exponent
    const auto decimal = shortest(std::abs(value));
    if (!decimal) return nlohmann::detail::to_chars(to, to + kDoubleTextBytes, value);
    if (value < 0) *to++ = '-';
    const char* const end = std::to_chars(to, to + kMostDigits, decimal->digits).ptr;
    return nlohmann::detail::dtoa_impl::format_buffer(to, static_cast<int>(end - to), decimal->exponent, kLeastPlace,
                                                      kMostPlace);
}

}  // namespace tuftwave::server::gltf
