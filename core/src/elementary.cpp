// Based on: T. J. Dekker. A floating-point technique for extending the available precision. 1971. Sections 2-5.
//           D. E. Knuth. The Art of Computer Programming, volume 2, 4.2.2, theorem B (the sum without a comparison).
//           W. J. Cody, W. Waite. Software Manual for the Elementary Functions. 1980. Argument reduction in parts.
// Differs:  Taylor coefficients instead of fitted ones; the remainder's low part is carried into every series, so that
//           the last addition is nearly the only rounding; no branches but selections, so that loops may be vectorised.
#include "tuftwave/elementary.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "elementary_bodies.hpp"

namespace tuftwave::elementary {
namespace {

using bodies::DoubleDouble, bodies::magnitude, bodies::polynomial, bodies::Rounded, bodies::rounded;
using bodies::sum_of, bodies::sum_of_ordered;

/// `a` as two halves of at most 26 bits, whose products are exact; |a| < 2^996.
DoubleDouble halves_of(const double a) {
    constexpr double kSplitter = 0x1p27 + 1;
    const double scaled = kSplitter * a;
    const double hi = scaled - (scaled - a);
    return {hi, a - hi};
}

/// a * b without loss, for factors below 2^996 and a product above 2^-960.
DoubleDouble product_of(const double a, const double b) {
    const double hi = a * b;
    const DoubleDouble p = halves_of(a), q = halves_of(b);
    return {hi, ((p.hi * q.hi - hi) + p.hi * q.lo + p.lo * q.hi) + p.lo * q.lo};
}

/// a * b to twice a double's precision.
DoubleDouble product_of(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble p = product_of(a.hi, b.hi);
    return sum_of_ordered(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// a / b to twice a double's precision.
DoubleDouble quotient_of(const DoubleDouble& a, const DoubleDouble& b) {
    const double hi = a.hi / b.hi;
    const DoubleDouble back = product_of(hi, b.hi);
    return {hi, ((a.hi - back.hi) - back.lo + a.lo - hi * b.lo) / b.hi};
}

constexpr int kFractionBits = 52;
constexpr std::uint64_t kExponentBias = 1023;
/// 2 to the power of `n`, -1022 <= n <= 1023, given in two's complement.
double power_of_two(const std::uint64_t n) { return std::bit_cast<double>((n + kExponentBias) << kFractionBits); }

// pi and pi/2 as double-doubles.
constexpr DoubleDouble kPi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr DoubleDouble kHalfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

// ln 2 as 42 bits, so that the product with a binary exponent is exact, and the rest.
constexpr DoubleDouble kLn2{0x1.62e42fefa38p-1, 0x1.ef35793c7673p-45};
constexpr double kOneOverLn2 = 0x1.71547652b82fep+0;

/// log(x) to about 65 bits, for a positive, finite `x`.
DoubleDouble log_of(const double x) {
    // x = 2^e (1 + f), with 1 + f in [sqrt(1/2), sqrt(2)); a subnormal x is made normal first.
    constexpr std::uint64_t kSqrtHalf = std::bit_cast<std::uint64_t>(0x1.6a09e667f3bcdp-1);
    const bool subnormal = x < std::numeric_limits<double>::min();
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(subnormal ? x * 0x1p54 : x);
    const std::int64_t exponent = static_cast<std::int64_t>(bits - kSqrtHalf) >> kFractionBits;
    const double f = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(exponent) << kFractionBits)) - 1;
    const double e = static_cast<double>(exponent) - (subnormal ? 54 : 0);

    // log(1 + f) = 2 artanh(s) = 2 (s + s^3/3 + s^5/5 + ...), s = f / (2 + f), |s| < 0.1716.
    // The first two terms need twice the precision, the others do not.
    constexpr DoubleDouble kThird{0x1.5555555555555p-2, 0x1.5555555555555p-56};
    constexpr std::array<double, 12> kFromFifth{1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11, 1.0 / 13, 1.0 / 15,
                                                1.0 / 17, 1.0 / 19, 1.0 / 21, 1.0 / 23, 1.0 / 25, 1.0 / 27};
    const DoubleDouble s = quotient_of({f, 0}, sum_of_ordered(2, f));
    const DoubleDouble z = product_of(s, s);
    const DoubleDouble series = sum_of_ordered(kThird.hi, kThird.lo + z.hi * polynomial(z.hi, kFromFifth));
    const DoubleDouble rest = product_of(s, product_of(z, series));
    const DoubleDouble artanh = sum_of_ordered(s.hi, rest.hi);

    const DoubleDouble sum = sum_of(e * kLn2.hi, 2 * artanh.hi);
    return sum_of_ordered(sum.hi, sum.lo + (e * kLn2.lo + 2 * (artanh.lo + (s.lo + rest.lo))));
}

/// e to the power of x.hi + x.lo.
double exp_of(const DoubleDouble& x) {
    // Beyond these the result is 0 or infinity; they keep the exponents below within range.
    constexpr double kLowest = -746, kHighest = 710;
    const double hi = x.hi < kLowest ? kLowest : (x.hi > kHighest ? kHighest : x.hi);
    const double lo = hi == x.hi ? x.lo : 0;

    // x = n ln 2 + r, |r| <= 0.3466.
    const Rounded n = rounded(hi * kOneOverLn2);
    const DoubleDouble r = sum_of(hi - n.value * kLn2.hi, lo - n.value * kLn2.lo);

    // e^r = 1 + r + r^2 (1/2! + r/3! + ... + r^12/14!).
    constexpr std::array<double, 13> kFromSquare{
        1.0 / 2,      1.0 / 6,       1.0 / 24,       1.0 / 120,       1.0 / 720,        1.0 / 5040,       1.0 / 40320,
        1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800, 1.0 / 87178291200};
    const DoubleDouble linear = sum_of_ordered(1, r.hi);
    const double small = linear.lo + (r.lo + r.hi * r.lo + r.hi * r.hi * polynomial(r.hi, kFromSquare));
    const double value = linear.hi + small;

    // Twice half of 2^n: n itself may lie outside a double's exponents, where the last product rounds or overflows.
    const std::uint64_t half = static_cast<std::uint64_t>(static_cast<std::int64_t>(n.integer) >> 1);
    return value * power_of_two(half) * power_of_two(n.integer - half);
}

/// atan(u.hi + u.lo) - u.hi, for |u| <= 1/16.
double atan_without_linear_term(const DoubleDouble& u) {
    constexpr std::array<double, 6> kFromCube{-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11, 1.0 / 13};
    const double z = u.hi * u.hi;
    return u.hi * z * polynomial(z, kFromCube) + u.lo * (1 - z);
}

// atan(k/8), k = 0..8: the nearest double, and the double nearest to what that one lacks.
constexpr std::array<DoubleDouble, 9> kAtanOfEighths{{
    {0, 0},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
}};

}  // namespace

SinCos sincos(const double x) { return bodies::sincos(x); }

double sin(const double x) { return sincos(x).sin; }

double cos(const double x) { return sincos(x).cos; }

double atan2(const double y, const double x) {
    const bool steep = magnitude(y) > magnitude(x);
    const double larger = steep ? magnitude(y) : magnitude(x);
    const double smaller = steep ? magnitude(x) : magnitude(y);

    // Scale both so that the larger is in [2, 4), or as near as a subnormal comes. Only then are exact products safe.
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(larger) >> kFractionBits;
    const double scale = std::bit_cast<double>(std::min(2047 - exponent, std::uint64_t{2046}) << kFractionBits);
    const double a = larger > 0 ? larger * scale : 1;
    const double b = smaller * scale;

    // atan(b/a) = atan(c) + atan(u), c = k/8 nearest to b/a, u = (b - c a) / (a + c b), |u| <= 1/16.
    const Rounded eighths = rounded(8 * (b / a));
    const double c = eighths.value / 8;
    const DoubleDouble along = product_of(c, a);
    const DoubleDouble across = product_of(c, b);
    const DoubleDouble denominator = sum_of_ordered(a, across.hi);
    const DoubleDouble u = quotient_of(sum_of(b - along.hi, -along.lo), {denominator.hi, denominator.lo + across.lo});
    // The index is at most 8 but for a NaN, which must not read outside the table either.
    const DoubleDouble& atan_of_c = kAtanOfEighths[std::min<std::uint64_t>(eighths.integer, 8)];

    // Unfold the octants: back from pi/2 where steep, back from pi where x is negative, on from pi/2 where both.
    const DoubleDouble base = steep ? kHalfPi : (x < 0 ? kPi : DoubleDouble{0, 0});
    const double direction = steep != (x < 0) ? -1 : 1;
    const DoubleDouble corner = sum_of(base.hi, direction * atan_of_c.hi);
    const DoubleDouble angle = sum_of(corner.hi, direction * u.hi);
    const double rest = base.lo + direction * (atan_of_c.lo + atan_without_linear_term(u));
    const double turned = angle.hi + (angle.lo + (corner.lo + rest));
    return bodies::with_sign(magnitude(turned), y);
}

double acos(const double x) {
    const double cosine = std::clamp(x, -1.0, 1.0);
    return atan2(std::sqrt((1 - cosine) * (1 + cosine)), cosine);
}

double exp(const double x) { return exp_of({x, 0}); }

double log(const double x) { return log_of(x).hi; }

double pow(const double x, const double y) {
    if (y == 1) return x;
    // The logarithm of any double but 1 is at least 2^-53, so that larger exponents give 0 or infinity just the same.
    constexpr double kLargestExponent = 0x1p70;
    const double exponent = std::clamp(y, -kLargestExponent, kLargestExponent);
    const DoubleDouble log_x = log_of(x > 0 ? x : 1);
    const DoubleDouble product = product_of(exponent, log_x.hi);
    const double power = exp_of({product.hi, product.lo + exponent * log_x.lo});

    const double power_of_zero = y > 0 ? 0 : (y < 0 ? std::numeric_limits<double>::infinity() : 1);
    return x > 0 ? power : power_of_zero;
}

}  // namespace tuftwave::elementary
