// Based on: R. Giulietti. The Schubfach way to render doubles. 2020. Sections 9.1-9.7, for floats.
// Differs: only for numbers below 2^24, whose powers of ten are no smaller than 1; the rest are rare.
#include "api/float_text.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

#include "api/write_nouns.hpp"

namespace tuftwave::server {
namespace {

/// 10^0 to 10^45 with 64 bits, rounded up.
constexpr std::array<std::uint64_t, 46> kPowersOfTen{
    0x8000000000000000, 0xa000000000000000, 0xc800000000000000, 0xfa00000000000000, 0x9c40000000000000,
    0xc350000000000000, 0xf424000000000000, 0x9896800000000000, 0xbebc200000000000, 0xee6b280000000000,
    0x9502f90000000000, 0xba43b74000000000, 0xe8d4a51000000000, 0x9184e72a00000000, 0xb5e620f480000000,
    0xe35fa931a0000000, 0x8e1bc9bf04000000, 0xb1a2bc2ec5000000, 0xde0b6b3a76400000, 0x8ac7230489e80000,
    0xad78ebc5ac620000, 0xd8d726b7177a8000, 0x878678326eac9000, 0xa968163f0a57b400, 0xd3c21bcecceda100,
    0x84595161401484a0, 0xa56fa5b99019a5c8, 0xcecb8f27f4200f3a, 0x813f3978f8940985, 0xa18f07d736b90be6,
    0xc9f2c9cd04674edf, 0xfc6f7c4045812297, 0x9dc5ada82b70b59e, 0xc5371912364ce306, 0xf684df56c3e01bc7,
    0x9a130b963a6c115d, 0xc097ce7bc90715b4, 0xf0bdc21abb48db21, 0x96769950b50d88f5, 0xbc143fa4e250eb32,
    0xeb194f8e1ae525fe, 0x92efd1b8d0cf37bf, 0xb7abc627050305ae, 0xe596b7b0c643c71a, 0x8f7e32ce7bea5c70,
    0xb35dbf821ae4f38c};

/// digits * 10^exponent
struct Decimal {
    std::uint32_t digits;
    int exponent;
};

/// floor(factor * g / 2^64), its last bit set where what was cut off is more than g's rounding.
std::uint32_t scaled(std::uint64_t g, std::uint32_t factor) {
    const std::uint64_t low = (g & 0xFFFFFFFF) * factor;
    const std::uint64_t high = (g >> 32) * factor + (low >> 32);
    return static_cast<std::uint32_t>(high >> 32) | static_cast<std::uint32_t>((high & 0xFFFFFFFF) > 1);
}

/// @param bits  of a normal float from 0 to 2^24
Decimal shortest(std::uint32_t bits) {
    // The float is c 2^q; whatever lies less than half way to its neighbours reads back as it.
    const std::uint32_t fraction = bits & 0x7FFFFF;
    const bool is_power_of_two = fraction == 0 && bits >> 23 > 1;  // its lower neighbour is half as far
    const std::uint32_t c = fraction | 0x800000;
    const int q = static_cast<int>(bits >> 23) - 150;
    // 10^k is the largest power of ten that is no longer than the interval.
    const int k = (q * 1262611 - (is_power_of_two ? 524031 : 0)) >> 22;
    const int h = q + ((-k * 1741647) >> 19) + 1;
    const std::uint64_t g = kPowersOfTen[static_cast<std::size_t>(-k)];
    // Four times the float and the interval's ends, in units of 10^k.
    const std::uint32_t middle = scaled(g, 4 * c << h);
    const std::uint32_t open = c & 1;  // an odd float is not read from the very ends
    const std::uint32_t lower = scaled(g, (4 * c - (is_power_of_two ? 1 : 2)) << h) + open;
    const std::uint32_t upper = scaled(g, (4 * c + 2) << h) - open;

    const std::uint32_t whole = middle / 4;
    const std::uint32_t tens = whole / 10;
    const bool is_below = lower <= 40 * tens, is_above = 40 * tens + 40 <= upper;
    if (is_below != is_above) return {tens + (is_above ? 1 : 0), k + 1};
    const bool is_down = lower <= 4 * whole, is_up = 4 * whole + 4 <= upper;
    if (is_down != is_up) return {whole + (is_up ? 1 : 0), k};
    const std::uint32_t half = 4 * whole + 2;
    return {whole + (middle > half || (middle == half && (whole & 1) != 0) ? 1 : 0), k};
}

Decimal without_zeros(Decimal decimal) {
    while (decimal.digits % 10 == 0) decimal = {decimal.digits / 10, decimal.exponent + 1};
    return decimal;
}

/// a * b - c without loss but for the last subtraction: Dekker's product.
double product_less(double a, double b, double c) {
    constexpr double kSplitter = 0x1p27 + 1;
    const double product = a * b;
    const double a_high = kSplitter * a - (kSplitter * a - a), a_low = a - a_high;
    const double b_high = kSplitter * b - (kSplitter * b - b), b_low = b - b_high;
    const double rest = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    return (product - c) + rest;
}

/// Whether nlohmann's Grisu2 finds these digits for the double nearest to them. Its arithmetic is good to a part in 512
/// of half a unit in the last place, so that of digits any nearer to the end of what reads back it makes longer ones.
bool is_found(const Decimal& decimal) {
    constexpr std::array<double, 23> kTens{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                           1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    constexpr double kMost = 0.5 - 1.0 / 128;  // units in the last place
    if (decimal.exponent >= 0) return true;
    if (decimal.exponent < -22) return false;
    const double ten = kTens[static_cast<std::size_t>(-decimal.exponent)];
    const double nearest = decimal.digits / ten;  // both are exact
    const double unit = std::bit_cast<double>(((std::bit_cast<std::uint64_t>(nearest) >> 52) - 52) << 52);
    return std::abs(product_less(nearest, ten, decimal.digits)) < kMost * unit * ten;
}

int count_digits(std::uint32_t number) {
    if (number >= 1'000'000) return 7 + (number >= 10'000'000 ? 1 : 0) + (number >= 100'000'000 ? 1 : 0);
    int count = 1;
    for (; number >= 10; number /= 10) ++count;
    return count;
}

/// "00" to "99"
constexpr auto kPairs = [] {
    std::array<char, 200> pairs{};
    for (std::size_t i = 0; i < 100; ++i) {
        pairs[2 * i] = static_cast<char>('0' + i / 10);
        pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
    }
    return pairs;
}();

constexpr int kMostDigits = 10;

/// The digits of a number behind zeros, with room to copy as many from any of them: a copy of fixed size takes no
/// branch.
struct Digits {
    explicit Digits(std::uint32_t number) {
        for (int at = kMostDigits - 2; at >= 0; at -= 2) {
            std::memcpy(text + at, &kPairs[2 * (number % 100)], 2);
            number /= 100;
        }
    }

    char text[2 * kMostDigits] = {};
};

char* write_decimal(char* to, const Decimal& decimal) {
    constexpr int kMostZeros = 3;  // behind the point
    const int count = count_digits(decimal.digits), point = count + decimal.exponent;
    const Digits digits(decimal.digits);
    const char* const first = digits.text + kMostDigits - count;
    if (point <= 0 && point >= -kMostZeros) {
        std::memcpy(to, "0.000", 5);
        std::memcpy(to + 2 - point, first, kMostDigits);
        return to + 2 - point + count;
    }
    if (point > 0 && decimal.exponent >= 0) {  // below 2^24, so there is no need of an exponent
        std::memcpy(to, first, kMostDigits);
        std::memset(to + count, '0', static_cast<std::size_t>(decimal.exponent));
        std::memcpy(to + point, ".0", 2);
        return to + point + 2;
    }
    const int whole = point > 0 ? point : 1;
    std::memcpy(to, first, kMostDigits);
    to[whole] = '.';
    std::memcpy(to + whole + 1, first + whole, kMostDigits);
    if (point > 0) return to + count + 1;
    to += count == 1 ? 1 : count + 1;
    std::memcpy(to, "e-", 2);
    std::memcpy(to + 2, &kPairs[2 * static_cast<std::size_t>(1 - point)], 2);
    return to + 4;
}

}  // namespace

char* write_float(char* to, float value) {
    constexpr std::uint32_t kSign = 0x80000000, kLeastNormal = 0x800000, kLimit = 0x4B800000;  // 2^24
    const auto bits = std::bit_cast<std::uint32_t>(value), magnitude = bits & ~kSign;
    if (magnitude == 0) {
        std::memcpy(to, bits == 0 ? "0.0" : "-0.0", 4);
        return to + (bits == 0 ? 3 : 4);
    }
    if (magnitude >= kLeastNormal && magnitude < kLimit) {
        const Decimal decimal = without_zeros(shortest(magnitude));
        if (is_found(decimal)) {
            *to = '-';
            return write_decimal(to + (bits >> 31), decimal);
        }
    }
    return nlohmann::detail::to_chars(to, to + kFloatTextBytes, short_number(static_cast<double>(value)));
}

}  // namespace tuftwave::server
