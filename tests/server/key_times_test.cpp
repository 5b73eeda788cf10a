#include "gltf/key_times.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tuftwave::server::gltf {
namespace {

Schedule schedule_of(double period, FrameRate fps, int hold) {
    Limits roomy;
    roomy.pictures = 600;
    return *make_schedule({period, fps, hold, ShortHolds::kLast, Sampling::kUniform}, Formulas::kCorrected, roomy);
}

TEST(KeyTimes, AreTheLargestFloatsBelowEachStart) {
    for (const FrameRate fps : {FrameRate{12, 1}, FrameRate{24, 1}, FrameRate{24000, 1001}, FrameRate{25, 1},
                                FrameRate{30, 1}, FrameRate{60, 1}}) {
        const Schedule schedule = schedule_of(600 / fps.value(), fps, 1);
        const std::vector<float> times = key_times(schedule);
        ASSERT_EQ(times.size(), 601U);
        EXPECT_EQ(times[0], 0.0F);
        for (int k = 1; k <= 600; ++k) {
            const auto start = static_cast<long double>(k) * static_cast<long double>(fps.denominator) /
                               static_cast<long double>(fps.numerator);
            const float time = times[static_cast<std::size_t>(k)];
            EXPECT_LT(static_cast<long double>(time), start) << k;
            EXPECT_GE(static_cast<long double>(std::nextafter(time, 1e9F)), start) << k;
        }
    }
}

TEST(KeyTimes, CloseTheLoopAtTheEndOfTheLastHold) {
    const std::vector<float> times = key_times(schedule_of(0.45, {24, 1}, 2));
    ASSERT_EQ(times.size(), 7U);  // six pictures and the first one again
    EXPECT_NEAR(static_cast<double>(times.back()), 11.0 / 24, 6e-8);
}

TEST(KeyTimes, OnePictureStillHasALength) { EXPECT_EQ(key_times(schedule_of(1, {24, 1}, 24)).size(), 2U); }

}  // namespace
}  // namespace tuftwave::server::gltf
