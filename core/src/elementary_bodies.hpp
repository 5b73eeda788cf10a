#pragma once

#include <algorithm>
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

/// The same sum by its even and its odd terms, which a CPU adds at once.
template <std::size_t kFirst = 0, std::size_t kCount>
TUFTWAVE_BODY double half_polynomial(const double square, const std::array<double, kCount>& c) {
    if constexpr (kFirst + 2 >= kCount) {
        return c[kFirst];
    } else {
        return c[kFirst] + square * half_polynomial<kFirst + 2>(square, c);
    }
}
template <std::size_t kCount>
TUFTWAVE_BODY double short_polynomial(const double z, const std::array<double, kCount>& c) {
    return half_polynomial<0>(z * z, c) + z * half_polynomial<1>(z * z, c);
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

/// Sine and cosine of `x` radians, |x| <= 10, at most 2 ulp off. Half the cost.
TUFTWAVE_BODY SinCos close_sincos(const double x) {
    constexpr std::array<double, 6> kSineFromCube{-0x1.5555555555555p-3, 0x1.1111111110bb2p-7,   -0x1.a01a019e83aa8p-13,
                                                  0x1.71de379689862p-19, -0x1.ae600b0226713p-26, 0x1.5e0b19c4eccadp-33};
    constexpr std::array<double, 6> kCosineFromFourth{0x1.5555555555555p-5,  -0x1.6c16c16c16967p-10,
                                                      0x1.a01a019f4eafdp-16, -0x1.27e4fa17d9c4ep-22,
                                                      0x1.1eeb68e8f3790p-29, -0x1.907da333d278fp-37};
    constexpr double kHalfPiRest = 0x1.0b4611a626331p-34;
    const Rounded n = rounded(x * kTwoOverPi);
    const double r = (x - n.value * kHalfPi1) - n.value * kHalfPiRest;
    const double z = r * r;
    const double sine = r + r * z * short_polynomial(z, kSineFromCube);
    const double cosine = 1 - (z / 2 - z * z * short_polynomial(z, kCosineFromFourth));
    // As in sincos(); a sign is the second bit of the quarter's number.
    const bool odd = (n.integer & 1) != 0;
    const std::uint64_t sine_sign = n.integer << 62 & kSignBit, cosine_sign = (n.integer + 1) << 62 & kSignBit;
    return {std::bit_cast<double>(std::bit_cast<std::uint64_t>(odd ? cosine : sine) ^ sine_sign),
            std::bit_cast<double>(std::bit_cast<std::uint64_t>(odd ? sine : cosine) ^ cosine_sign)};
}

/// The angle of a slope, radians in [-pi/2, pi/2]: atan2(rise, run) for run >= 0, at most 2 ulp off. A third of its
/// cost.
TUFTWAVE_BODY double slope_angle(const double rise, const double run) {
    // atan(u) = u + u^3 P(u^2) for |u| <= tan(pi/8), fitted by Chebyshev's polynomials to 6e-18.
    constexpr std::array<double, 11> kFromCube{-0x1.5555555555555p-2, 0x1.999999999934cp-3,  -0x1.2492492436201p-3,
                                               0x1.c71c71853d7c8p-4,  -0x1.745d0b28a7649p-4, 0x1.3b12630643e8ap-4,
                                               -0x1.10fa77b104ae8p-4, 0x1.dfe6497394f40p-5,  -0x1.a0999c2994d42p-5,
                                               0x1.4162bf84bf0bfp-5,  -0x1.3a31b0297d745p-6};
    constexpr double kEighthOfPi = 0x1.a827999fcef32p-2;  // its tangent
    constexpr double kQuarterPi = 0x1.921fb54442d18p-1, kHalfPi = 0x1.921fb54442d18p+0;
    constexpr double kLeast = 0x1p-1000;  // the angle of no slope at all is 0
    const double height = magnitude(rise);
    const double smaller = std::min(height, run), larger = std::max(std::max(height, run), kLeast);
    // Above pi/8, the angle is pi/4 and that of (smaller - larger) / (smaller + larger).
    const bool far = smaller > kEighthOfPi * larger;
    const double u = (smaller - (far ? larger : 0.0)) / (larger + (far ? smaller : 0.0));
    const double z = u * u;
    const double angle = (far ? kQuarterPi : 0.0) + (u + u * z * short_polynomial(z, kFromCube));
    return with_sign(height > run ? kHalfPi - angle : angle, rise);
}

}  // namespace tuftwave::elementary::bodies
