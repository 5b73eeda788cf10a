#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "elementary_bodies.hpp"

/// Elementary functions good to a few units in the last place, for what ends as a float: half the cost.
namespace tuftwave::elementary::bodies {

/// polynomial() by its even and its odd terms, which a CPU adds at once.
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
