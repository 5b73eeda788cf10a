#include "tuftwave/wave.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "support.hpp"
#include "tuftwave/math.hpp"

namespace tuftwave {
namespace {

using test::is_refused;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double height(const Wave& wave, const double x, const double psi) {
    return wave_height(wave, wave_envelope(wave, x), x, psi);
}

/// Equation (1) as the paper prints it, in long double.
long double printed(const Wave& wave, const double x, const double psi) {
    const long double a = wave.amplitude, k = wave.spatial_period, s = wave.lightness, p = wave.tip_exponent;
    return -(a / s) * std::pow(x / static_cast<long double>(kPi), p) * (std::cos(x / k - psi) + 1 / s);
}

TEST(Wave, IsEquation1) {
    test::Random random(11);
    for (int i = 0; i < 20'000; ++i) {
        Wave wave;
        wave.amplitude = random.between(-3, 3);
        wave.spatial_period = (i % 2 == 0 ? 1 : -1) * random.between(0.05, 5);
        wave.lightness = (i % 3 == 0 ? -1 : 1) * random.between(0.05, 5);
        wave.tip_exponent = random.between(0.05, 8);
        const double x = random.between(0, kPi), psi = random.between(-10, 10);
        const auto wanted = static_cast<double>(printed(wave, x, psi));
        // The two terms may cancel, so the error is measured against their size.
        const double size = std::abs(wave_envelope(wave, x)) * (1 + 1 / std::abs(wave.lightness));
        ASSERT_NEAR(height(wave, x, psi), wanted, 2e-14 * size) << "seed 11, case " << i;
    }
}

TEST(Wave, StandsStillAtTheRootAndIsLiveliestAtTheTip) {
    const Wave wave;
    EXPECT_EQ(height(wave, 0, 1), 0);
    double before = 0;
    for (int i = 1; i <= 32; ++i) {
        const double envelope = std::abs(wave_envelope(wave, kPi * i / 32));
        EXPECT_GT(envelope, before) << i;
        before = envelope;
    }
}

TEST(Wave, DroopsLessTheLargerTheLightness) {
    const auto mean_tip = [](const double lightness) {
        Wave wave;
        wave.lightness = lightness;
        double sum = 0;
        for (int n = 0; n < 360; ++n) sum += height(wave, kPi, 2 * kPi * n / 360);
        return sum / 360;
    };
    EXPECT_NEAR(mean_tip(1.2), -0.8 / 1.44, 1e-12);  // the droop is a / s^2
    EXPECT_GT(mean_tip(2), mean_tip(1.2));
}

TEST(Wave, RunsToTheTipOrToTheRootByTheSignOfK) {
    // A little later, the same height is found a little further along: x grows by k times the phase that has passed.
    for (const double k : {1.0, -1.0, 0.3, -2.0}) {
        Wave wave;
        wave.spatial_period = k;
        const double x = 1.5, later = 0.01;
        EXPECT_NEAR(height(wave, x + k * later, later) / wave_envelope(wave, x + k * later),
                    height(wave, x, 0) / wave_envelope(wave, x), 1e-12)
            << k;
    }
}

TEST(Wave, WithoutAmplitudeIsStraight) {
    Wave wave;
    wave.amplitude = 0;
    EXPECT_FALSE(check_wave(wave, {}));
    for (int i = 0; i <= 10; ++i) EXPECT_EQ(height(wave, kPi * i / 10, 0.7), 0);
}

TEST(CheckWave, AcceptsEveryEnd) {
    for (const double sign : {1.0, -1.0}) {
        for (const double size : {0.05, 100.0}) {
            EXPECT_FALSE(check_wave(
                {.amplitude = sign * 100, .spatial_period = sign * size, .lightness = -sign * size, .tip_exponent = 8},
                {}));
        }
    }
}

TEST(CheckWave, RefusesWithCodeAndField) {
    const struct {
        const char* name;
        std::function<void(Wave&)> change;
        ErrorCode code;
        const char* field;
    } cases[] = {
        {"amplitude not a number", [](Wave& w) { w.amplitude = kNaN; }, ErrorCode::kNotFinite, "/amplitude"},
        {"amplitude infinite", [](Wave& w) { w.amplitude = kInfinity; }, ErrorCode::kNotFinite, "/amplitude"},
        {"amplitude too large", [](Wave& w) { w.amplitude = -101; }, ErrorCode::kOutOfRange, "/amplitude"},
        {"no spatial period", [](Wave& w) { w.spatial_period = 0; }, ErrorCode::kOutOfRange, "/spatial_period"},
        {"spatial period near zero", [](Wave& w) { w.spatial_period = -0.049; }, ErrorCode::kOutOfRange,
         "/spatial_period"},
        {"spatial period too large", [](Wave& w) { w.spatial_period = -101; }, ErrorCode::kOutOfRange,
         "/spatial_period"},
        {"spatial period not a number", [](Wave& w) { w.spatial_period = kNaN; }, ErrorCode::kNotFinite,
         "/spatial_period"},
        {"no lightness", [](Wave& w) { w.lightness = 0; }, ErrorCode::kOutOfRange, "/lightness"},
        {"lightness near zero", [](Wave& w) { w.lightness = 0.049; }, ErrorCode::kOutOfRange, "/lightness"},
        {"lightness infinite", [](Wave& w) { w.lightness = -kInfinity; }, ErrorCode::kNotFinite, "/lightness"},
        {"no tip exponent", [](Wave& w) { w.tip_exponent = 0; }, ErrorCode::kOutOfRange, "/tip_exponent"},
        {"negative tip exponent", [](Wave& w) { w.tip_exponent = -1; }, ErrorCode::kOutOfRange, "/tip_exponent"},
        {"tip exponent too large", [](Wave& w) { w.tip_exponent = 8.1; }, ErrorCode::kOutOfRange, "/tip_exponent"},
    };
    for (const auto& wrong : cases) {
        Wave wave;
        wrong.change(wave);
        EXPECT_TRUE(is_refused(check_wave(wave, {}), wrong.code, wrong.field)) << wrong.name;
    }
}

}  // namespace
}  // namespace tuftwave
