#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "tuftwave/elementary.hpp"
#include "tuftwave/wide.hpp"

/// Elementary functions to put into loops that become vectors, and what they and those of elementary.cpp are made of.
/// No branches but selections.
namespace tuftwave::elementary::bodies {

/// A number as the unevaluated sum of two doubles, `lo` no larger than the last place of `hi`.
struct DoubleDouble {
    double hi, lo;
};

/// a + b without loss, for |a| >= |b| or a = 0.
TUFTWAVE_BODY DoubleDouble sum_of_ordered(const double a, const double b) {
    const double hi = a + b;
    return {hi, b - (hi - a)};
}

/// a + b without loss.
TUFTWAVE_BODY DoubleDouble sum_of(const double a, const double b) {
    const double hi = a + b;
    const double b_in_hi = hi - a;
    return {hi, (a - (hi - b_in_hi)) + (b - b_in_hi)};
}

/// c0 + c1 z + c2 z^2 + ..., by Horner's rule.
template <std::size_t kFirst = 0, std::size_t kCount>
TUFTWAVE_BODY double polynomial(const double z, const std::array<double, kCount>& c) {
    if constexpr (kFirst + 1 == kCount) {
        return c[kFirst];
    } else {
        return c[kFirst] + z * polynomial<kFirst + 1>(z, c);
    }
}

/// A double rounded to the nearest integer, ties to even, as a double and as an integer in two's complement.
struct Rounded {
    double value;
    std::uint64_t integer;
};

/// @param x  |x| < 2^51; beyond, the values are meaningless but nothing is undefined
TUFTWAVE_BODY Rounded rounded(const double x) {
    // Adding 1.5 * 2^52 leaves no room for a fraction: the integer stands in the last bits of the sum.
    constexpr double kNoFraction = 0x1.8p52;
    const double shifted = x + kNoFraction;
    return {shifted - kNoFraction, std::bit_cast<std::uint64_t>(shifted) - std::bit_cast<std::uint64_t>(kNoFraction)};
}

inline constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63;

TUFTWAVE_BODY double magnitude(const double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~kSignBit);
}

/// @param x  >= 0 @return  with the sign of `of`
TUFTWAVE_BODY double with_sign(const double x, const double of) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) | (std::bit_cast<std::uint64_t>(of) & kSignBit));
}

// pi/2 in four parts. The first three have 33 bits, so that their products with a quarter turn's number, which has at
// most 20 bits for |x| <= 1e6, are exact; together they reach 2^-157, far below the smallest remainder, 2^-60.5 (n =
// 29).
inline constexpr double kHalfPi1 = 0x1.921fb544p+0, kHalfPi2 = 0x1.0b4611a6p-34, kHalfPi3 = 0x1.3198a2ep-69;
inline constexpr double kHalfPi4 = 0x1.b839a252049c1p-104;
inline constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;

/// As elementary::sincos(), to the same bits.
TUFTWAVE_BODY SinCos sincos(const double x) {
    // x = n pi/2 + r, |r| <= pi/4. The first difference is exact.
    const Rounded n = rounded(x * kTwoOverPi);
    const DoubleDouble second = sum_of(x - n.value * kHalfPi1, -(n.value * kHalfPi2));
    const DoubleDouble third = sum_of(second.hi, -(n.value * kHalfPi3));
    const DoubleDouble r = sum_of(third.hi, second.lo + third.lo - n.value * kHalfPi4);

    // sin r = r + r^3 (-1/3! + r^2/5! - ... + r^14/17!), and by the derivative r.lo (1 - r^2/2).
    constexpr std::array<double, 8> kSineFromCube{
        -1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
        -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
    // cos r = 1 - r^2/2 + r^4 (1/4! - r^2/6! + ... + r^12/16!), and by the derivative -r.lo r.
    constexpr std::array<double, 7> kCosineFromFourth{
        1.0 / 24, -1.0 / 720, 1.0 / 40320, -1.0 / 3628800, 1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};
    const double z = r.hi * r.hi;
    const double sine = r.hi + (r.hi * z * polynomial(z, kSineFromCube) + r.lo * (1 - z / 2));
    const DoubleDouble square = sum_of_ordered(1, -z / 2);
    const double cosine = square.hi + (square.lo + (z * z * polynomial(z, kCosineFromFourth) - r.hi * r.lo));

    // Quarter turn n: sin x is sin r, cos r, -sin r, -cos r in turn, and cos x is one quarter ahead.
    const bool odd = (n.integer & 1) != 0;
    const double sine_of_x = odd ? cosine : sine;
    const double cosine_of_x = odd ? sine : cosine;
    return {x == 0 ? x : ((n.integer & 2) != 0 ? -sine_of_x : sine_of_x),
            ((n.integer + 1) & 2) != 0 ? -cosine_of_x : cosine_of_x};
}

}  // namespace tuftwave::elementary::bodies
