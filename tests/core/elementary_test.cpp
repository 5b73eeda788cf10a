#include "tuftwave/elementary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <utility>

namespace tuftwave::elementary {
namespace {

constexpr int kSamples = 200000;
constexpr std::uint64_t kSeed = 20240611;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
// The nearest doubles to pi and pi/2.
constexpr double kPi = 0x1.921fb54442d18p+1, kHalfPi = 0x1.921fb54442d18p+0;
// Logarithms of about the smallest subnormal, the smallest normal and the largest double, rounded inwards.
constexpr double kLowestLog = -744.4, kLowestNormalLog = -708.39, kHighestLog = 709.78;

/// The reference must be at least 10 bits finer than a double, or it measures itself.
constexpr bool kReferenceIsFiner = std::numeric_limits<long double>::digits >= 63;

/// Random arguments from raw bits: standard distributions differ between libraries. Never ask for two within one
/// call's parentheses: compilers differ in which comes first.
class Arguments {
  public:
    double uniform(const double low, const double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    /// A number whose binary exponent is uniform in [low, high).
    double of_any_size(const int low, const int high) {
        const int exponent = low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low));
        return std::ldexp(uniform(1, 2), exponent);
    }
    double either_sign(const double x) { return (engine_() & 1) != 0 ? -x : x; }

  private:
    std::mt19937_64 engine_{kSeed};
};

/// The largest error seen, and where.
class Worst {
  public:
    explicit Worst(std::string name) : name_(std::move(name)) {}

    void compare(const double got, const long double wanted, const double x, const double y = 0) {
        ++count_;
        int exponent = 0;
        std::frexp(wanted, &exponent);
        constexpr int kSmallestExponent = std::numeric_limits<double>::min_exponent;
        const long double place = std::ldexp(1.0L, std::max(exponent, kSmallestExponent) - 53);
        const auto ulps = static_cast<double>(std::fabs(static_cast<long double>(got) - wanted) / place);
        if (ulps <= ulps_) return;
        ulps_ = ulps, x_ = x, y_ = y;
    }
    void expect_at_most(const double bound) const {
        std::cout << name_ << ": largest error " << ulps_ << " ulp in " << count_ << " arguments, seed " << kSeed
                  << ", at " << std::hexfloat << x_ << ' ' << y_ << std::defaultfloat << '\n';
        EXPECT_GE(count_, kSamples);
        EXPECT_LE(ulps_, bound) << name_;
    }

  private:
    std::string name_;
    double ulps_ = 0, x_ = 0, y_ = 0;
    int count_ = 0;
};

TEST(Elementary, SineAndCosineKeepTheStatedErrorUpToAMillionRadians) {
    if (!kReferenceIsFiner) GTEST_SKIP() << "long double is no finer than double";
    Worst sine("sin"), cosine("cos");
    const auto compare = [&](const double x) {
        const SinCos both = sincos(x);
        sine.compare(both.sin, std::sin(static_cast<long double>(x)), x);
        cosine.compare(both.cos, std::cos(static_cast<long double>(x)), x);
    };
    Arguments arguments;
    for (int i = 0; i < kSamples; ++i) {
        compare(arguments.uniform(-kPi, kPi));
        compare(arguments.uniform(-1e6, 1e6));
        compare(arguments.either_sign(arguments.of_any_size(-1022, 0)));
    }
    // Every multiple of pi/2 in range, where almost all digits cancel; the worst of all is the 29th.
    for (int n = 1; n * kHalfPi <= 1e6; ++n) {
        const auto multiple = static_cast<double>(n * 1.57079632679489661923132169163975144L);
        compare(multiple);
        compare(std::nextafter(multiple, 0));
        if (n % 16 == 1) compare(multiple + arguments.uniform(-1e-3, 1e-3));
    }
    sine.expect_at_most(0.85);
    cosine.expect_at_most(0.85);
}

TEST(Elementary, ArcTangentKeepsTheStatedErrorInAllQuadrantsAndSizes) {
    if (!kReferenceIsFiner) GTEST_SKIP() << "long double is no finer than double";
    Worst worst("atan2");
    const auto compare = [&](const double y, const double x) {
        worst.compare(atan2(y, x), std::atan2(static_cast<long double>(y), static_cast<long double>(x)), y, x);
    };
    Arguments arguments;
    for (int i = 0; i < kSamples; ++i) {
        const double inside = arguments.uniform(-1, 1);
        compare(arguments.uniform(-1, 1), inside);
        const double size = arguments.either_sign(arguments.of_any_size(-500, 500));
        compare(arguments.either_sign(size * arguments.of_any_size(-480, 480)), size);
        // Midway between two eighths, where the remainder is largest.
        const double midway = static_cast<double>(i % 8) / 8 + 1.0 / 16 + arguments.uniform(-1e-6, 1e-6);
        const double x = arguments.either_sign(arguments.uniform(0.5, 2));
        compare(midway * x, x);
        compare(x, midway * x);
    }
    worst.expect_at_most(0.55);
}

TEST(Elementary, ArcCosineKeepsTheStatedErrorAlsoNearTheEnds) {
    if (!kReferenceIsFiner) GTEST_SKIP() << "long double is no finer than double";
    Worst worst("acos");
    const auto compare = [&](const double x) { worst.compare(acos(x), std::acos(static_cast<long double>(x)), x); };
    Arguments arguments;
    for (int i = 0; i < kSamples; ++i) {
        compare(arguments.uniform(-1, 1));
        compare(arguments.either_sign(1 - arguments.of_any_size(-52, 0) / 2));
        compare(arguments.either_sign(arguments.of_any_size(-100, 0)));
    }
    worst.expect_at_most(1.6);
}

TEST(Elementary, ExponentialKeepsTheStatedErrorDownToSubnormals) {
    if (!kReferenceIsFiner) GTEST_SKIP() << "long double is no finer than double";
    Worst normal("exp"), subnormal("exp, subnormal results");
    const auto compare = [](Worst& worst, const double x) {
        worst.compare(exp(x), std::exp(static_cast<long double>(x)), x);
    };
    Arguments arguments;
    for (int i = 0; i < kSamples; ++i) {
        compare(normal, arguments.uniform(kLowestNormalLog, kHighestLog));
        compare(normal, arguments.uniform(-1, 1));
        compare(normal, arguments.either_sign(arguments.of_any_size(-100, 0)));
        // Midway between two powers of two, where the remainder is largest.
        compare(normal, (i % 2000 - 999.5) * 0.6931471805599453 + arguments.uniform(-1e-6, 1e-6));
        compare(subnormal, arguments.uniform(kLowestLog, kLowestNormalLog));
    }
    normal.expect_at_most(0.65);
    subnormal.expect_at_most(0.85);
}

TEST(Elementary, LogarithmKeepsTheStatedErrorAlsoNearOne) {
    if (!kReferenceIsFiner) GTEST_SKIP() << "long double is no finer than double";
    Worst worst("log");
    const auto compare = [&](const double x) { worst.compare(log(x), std::log(static_cast<long double>(x)), x); };
    Arguments arguments;
    for (int i = 0; i < kSamples; ++i) {
        compare(arguments.uniform(0.5, 2));
        compare(arguments.of_any_size(-1074, 1024));
        compare(1 + arguments.either_sign(arguments.of_any_size(-52, -2)));
    }
    worst.expect_at_most(0.51);
}

TEST(Elementary, PowerKeepsTheStatedErrorForTipsAndForAnyExponent) {
    if (!kReferenceIsFiner) GTEST_SKIP() << "long double is no finer than double";
    Worst tips("pow, tips"), any("pow, any"), subnormal("pow, subnormal results");
    const auto compare = [](Worst& worst, const double x, const double y) {
        worst.compare(pow(x, y), std::pow(static_cast<long double>(x), static_cast<long double>(y)), x, y);
    };
    Arguments arguments;
    for (int i = 0; i < kSamples; ++i) {
        // What the shape of a tip asks for: (x/pi)^p.
        const double sharpness = arguments.uniform(0.05, 8);
        compare(tips, arguments.uniform(1e-12, kPi) / kPi, sharpness);
        compare(tips, arguments.of_any_size(-40, 1) / kPi, sharpness);
        // Any base, and an exponent that takes it anywhere between the smallest and the largest double.
        const double x = arguments.of_any_size(-1074, 1024);
        const double near_one = 1 + arguments.either_sign(arguments.of_any_size(-50, -1));
        compare(any, x, arguments.uniform(kLowestNormalLog, kHighestLog) / std::log(x));
        compare(any, near_one, arguments.uniform(kLowestNormalLog, kHighestLog) / std::log(near_one));
        compare(subnormal, x, arguments.uniform(kLowestLog, kLowestNormalLog) / std::log(x));
    }
    tips.expect_at_most(0.65);
    any.expect_at_most(0.65);
    subnormal.expect_at_most(0.85);
}

/// Equal in every bit, so that the signs of zeros count.
void expect_same(const double got, const double wanted) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(got), std::bit_cast<std::uint64_t>(wanted)) << got << " is not " << wanted;
}

TEST(Elementary, SineAndCosineOfZeroAreExact) {
    expect_same(sin(0.0), 0.0);
    expect_same(sin(-0.0), -0.0);
    expect_same(cos(0.0), 1);
    expect_same(cos(-0.0), 1);
    expect_same(sin(5e-324), 5e-324);
    expect_same(sin(kHalfPi), 1);
    expect_same(cos(kPi), -1);
}

TEST(Elementary, SineIsOddAndCosineIsEvenInEveryBit) {
    Arguments arguments;
    for (int i = 0; i < 10000; ++i) {
        const double x = arguments.uniform(0, 100);
        const SinCos there = sincos(x), back = sincos(-x);
        expect_same(back.sin, -there.sin);
        expect_same(back.cos, there.cos);
        expect_same(there.sin, sin(x));
        expect_same(there.cos, cos(x));
        EXPECT_NEAR(there.sin * there.sin + there.cos * there.cos, 1, 4e-16);  // two roundings of at most 1.1e-16 each
    }
}

TEST(Elementary, ArcTangentOnTheAxesAndDiagonalsIsExact) {
    expect_same(atan2(0.0, 0.0), 0);
    expect_same(atan2(-0.0, 0.0), -0.0);
    expect_same(atan2(0.0, 1), 0);
    expect_same(atan2(-0.0, 1), -0.0);
    expect_same(atan2(1, 0.0), kHalfPi);
    expect_same(atan2(-1, 0.0), -kHalfPi);
    expect_same(atan2(1, -0.0), kHalfPi);
    expect_same(atan2(0.0, -1), kPi);
    expect_same(atan2(-0.0, -1), -kPi);
    expect_same(atan2(3, 3), kPi / 4);
    expect_same(atan2(-3, 3), -kPi / 4);
    expect_same(atan2(3, -3), 2.356194490192345);  // 3 pi/4, rounded
}

TEST(Elementary, ArcTangentSurvivesTheLargestAndSmallestNumbers) {
    constexpr double kLargest = std::numeric_limits<double>::max(), kSmallest = 5e-324;
    expect_same(atan2(kLargest, kLargest), kPi / 4);
    expect_same(atan2(kSmallest, kSmallest), kPi / 4);
    expect_same(atan2(kSmallest, kLargest), 0);
    expect_same(atan2(kSmallest, -kLargest), kPi);
    expect_same(atan2(kLargest, kSmallest), kHalfPi);
    expect_same(atan2(1e308, 0.5e308), atan2(2, 1));
    expect_same(atan2(2 * kSmallest, kSmallest), atan2(2, 1));
    expect_same(atan2(kSmallest, 1), kSmallest);
}

TEST(Elementary, ArcTangentNeverTurnsBackAroundTheCircle) {
    // Steps of 1e-4 rad are 1e12 times the error, so any fault at a seam between octants or eighths shows.
    double before = -kPi;
    for (int i = 1; i < 62831; ++i) {
        const double angle = -kPi + 1e-4 * i;
        const SinCos both = sincos(angle);
        const double found = atan2(both.sin, both.cos);
        ASSERT_GT(found, before) << "step " << i;
        ASSERT_NEAR(found, angle, 1e-15) << "step " << i;
        before = found;
    }
}

TEST(Elementary, ArcCosineOfTheLandmarksIsExactAndClampsBeyond) {
    expect_same(acos(1), 0);
    expect_same(acos(0.0), kHalfPi);
    expect_same(acos(-1), kPi);
    expect_same(acos(1.5), 0);
    expect_same(acos(-1.5), kPi);
}

TEST(Elementary, ExponentialOfTheLandmarksIsExact) {
    expect_same(exp(0.0), 1);
    expect_same(exp(-0.0), 1);
    expect_same(exp(1), 0x1.5bf0a8b145769p+1);  // e, rounded
    expect_same(exp(709.79), kInfinity);
    expect_same(exp(1e300), kInfinity);
    expect_same(exp(kInfinity), kInfinity);
    expect_same(exp(-745.13), 5e-324);
    expect_same(exp(-745.14), 0);
    expect_same(exp(-1e300), 0);
    expect_same(exp(-kInfinity), 0);
}

TEST(Elementary, LogarithmOfTheLandmarksIsExact) {
    constexpr double kLn2 = 0x1.62e42fefa39efp-1;  // ln 2, rounded
    expect_same(log(1), 0);
    expect_same(log(2), kLn2);
    expect_same(log(0.5), -kLn2);
    expect_same(log(0x1p512), 512 * kLn2);
    expect_same(log(0x1p-1022), std::log(0x1p-1022));
}

TEST(Elementary, ExponentialAndLogarithmGrowEverywhere) {
    double exp_before = 0, log_before = -kInfinity;
    for (int i = 1; i < 100000; ++i) {
        const double exp_now = exp(-50 + 1e-3 * i), log_now = log(1e-3 * i);
        ASSERT_GT(exp_now, exp_before) << "step " << i;
        ASSERT_GT(log_now, log_before) << "step " << i;
        exp_before = exp_now, log_before = log_now;
    }
}

TEST(Elementary, PowerOfTheLandmarksIsExact) {
    expect_same(pow(0, 0.05), 0);
    expect_same(pow(0, 1), 0);
    expect_same(pow(0, 0), 1);
    expect_same(pow(0, -1), kInfinity);
    expect_same(pow(1, 1e300), 1);
    expect_same(pow(1, -0.3), 1);
    expect_same(pow(7, 0), 1);
    expect_same(pow(10, 3), 1000);
    expect_same(pow(10, 22), 1e22);
    expect_same(pow(0.25, 0.5), 0.5);
    expect_same(pow(0x1p-500, 2), 0x1p-1000);
    expect_same(pow(4, -537), 0x1p-1074);
    expect_same(pow(2, 1024), kInfinity);
    expect_same(pow(0.5, 1e300), 0);
    expect_same(pow(0.5, -1e300), kInfinity);
    expect_same(pow(1.0000000000000002, 1e300), kInfinity);
    expect_same(pow(0.9999999999999999, 1e300), 0);
    expect_same(pow(2, 5e-324), 1);
}

TEST(Elementary, PowerAgreesWithProductsAndRoots) {
    Arguments arguments;
    constexpr double kOneUlp = 0x1p-52;
    for (int i = 0; i < 10000; ++i) {
        const double x = arguments.of_any_size(-500, 500);
        expect_same(pow(x, 1), x);
        ASSERT_NEAR(pow(x, 2) / (x * x), 1, kOneUlp) << x;
        ASSERT_NEAR(pow(x, 0.5) / std::sqrt(x), 1, kOneUlp) << x;
        ASSERT_NEAR(pow(x, -1) * x, 1, kOneUlp) << x;
        // An error of half an ulp in a logarithm of up to 347 grows to 347 * 1.1e-16 in the exponential.
        ASSERT_NEAR(exp(log(x)) / x, 1, 4e-14) << x;
    }
}

TEST(Elementary, EveryMachineGivesTheSameBits) {
    // A hash (FNV-1a) of many results: it changes when any last bit does, and with it every picture we ever served.
    std::uint64_t hash = 0xcbf29ce484222325;
    const auto add = [&hash](const double value) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3;
    };
    Arguments arguments;
    for (int i = 0; i < kSamples; ++i) {
        const SinCos both = sincos(arguments.uniform(-1e6, 1e6));
        add(both.sin);
        add(both.cos);
        const double y = arguments.uniform(-1, 1), x = arguments.uniform(-1, 1);
        add(atan2(y, x));
        add(acos(x));
        add(exp(700 * y));
        add(log(arguments.of_any_size(-1022, 1024)));
        add(pow(arguments.of_any_size(-40, 40), 8 * y));
    }
    EXPECT_EQ(hash, 9402123033413456942u);
}

}  // namespace
}  // namespace tuftwave::elementary
