#include "tuftwave/schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "support.hpp"
#include "tuftwave/math.hpp"

namespace tuftwave {
namespace {

using test::is_refused;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The limits with as many pictures as there can be frames, so that every case of the method can be looked at.
Limits wide_limits() {
    Limits limits;
    limits.pictures = limits.frames;
    return limits;
}

/// A cycle of so many frames at 24 frames per second.
Timing timing_of(const int frames, const int hold) {
    Timing timing;
    timing.period = frames / 24.0;
    timing.hold = hold;
    return timing;
}

Result<Schedule> made(const int frames, const int hold, const Formulas formulas = Formulas::kCorrected) {
    return make_schedule(timing_of(frames, hold), formulas, wide_limits());
}

// The paper's own example: 24 frames per second, T = 0.45 s, on twos.
TEST(Schedule, ElevenFramesHeldByTwoGiveSixPictures) {
    const Result<Schedule> schedule = make_schedule({}, Formulas::kAsPrinted, {});
    ASSERT_TRUE(schedule);
    EXPECT_EQ(schedule->frames, 11);
    EXPECT_EQ(schedule->pictures, 6);
    EXPECT_EQ(schedule->holds, (std::vector<int>{2, 2, 2, 2, 2, 1}));
    EXPECT_EQ(schedule->starts, (std::vector<int>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(schedule->requested_period, 0.45);
    EXPECT_EQ(schedule->period, 11.0 / 24);
}

TEST(Schedule, HoldsSumToTheFramesAndAreNoLongerThanAsked) {
    for (int hold = 1; hold <= 24; ++hold) {
        for (int frames = 1; frames <= 1440; ++frames) {
            const Result<Schedule> schedule = made(frames, hold);
            ASSERT_TRUE(schedule) << frames << " frames, hold " << hold;
            ASSERT_EQ(schedule->frames, frames);
            ASSERT_EQ(schedule->pictures, (frames + hold - 1) / hold);
            ASSERT_EQ(std::accumulate(schedule->holds.begin(), schedule->holds.end(), 0), frames);
            ASSERT_GE(schedule->holds.back(), 1);
            ASSERT_LE(schedule->holds.front(), hold);
            int start = 0;
            for (std::size_t n = 0; n < schedule->holds.size(); start += schedule->holds[n++])
                ASSERT_EQ(schedule->starts[n], start);
        }
    }
}

// The paper's rule: K = N_dup N_pict - N_frame; the first N_pict - K pictures are held N_dup frames, the rest one less.
TEST(Schedule, IsThePapersRuleWhereverThatIsDefined) {
    for (int hold = 1; hold <= 24; ++hold) {
        for (int frames = 1; frames <= 1440; ++frames) {
            const Result<Schedule> schedule = made(frames, hold);
            const int short_pictures = hold * schedule->pictures - frames;
            if (short_pictures > schedule->pictures) continue;
            for (int n = 0; n < schedule->pictures; ++n) {
                const int wanted = n < schedule->pictures - short_pictures ? hold : hold - 1;
                ASSERT_EQ(schedule->holds[static_cast<std::size_t>(n)], wanted)
                    << frames << " frames, hold " << hold << ", picture " << n;
            }
        }
    }
}

TEST(Schedule, AsPrintedRefusesJustTheCasesThatThePaperLeavesOpen) {
    for (int hold = 1; hold <= 24; ++hold) {
        int refused = 0;
        for (int frames = 1; frames <= 1440; ++frames) {
            const Result<Schedule> schedule = made(frames, hold, Formulas::kAsPrinted);
            if (schedule) continue;
            EXPECT_TRUE(is_refused(schedule, ErrorCode::kUndefinedAsPrinted, "/hold"));
            ++refused;
        }
        EXPECT_EQ(refused, (hold - 1) * (hold - 2) / 2) << "hold " << hold;
    }
}

TEST(Schedule, SpreadingKeepsTheHoldsButNotTheirOrder) {
    for (int hold = 1; hold <= 24; ++hold) {
        for (int frames = 1; frames <= 1440; frames += 7) {
            Timing timing = timing_of(frames, hold);
            timing.short_holds = ShortHolds::kSpread;
            const Result<Schedule> spread = make_schedule(timing, Formulas::kCorrected, wide_limits()),
                                   last = made(frames, hold);
            ASSERT_TRUE(spread);
            for (int n = 0; n < spread->pictures; ++n)
                ASSERT_EQ(spread->starts[static_cast<std::size_t>(n)], n * frames / spread->pictures);
            std::vector<int> a = spread->holds, b = last->holds;
            std::sort(a.begin(), a.end());
            std::sort(b.begin(), b.end());
            ASSERT_EQ(a, b) << frames << " frames, hold " << hold;
        }
    }
}

TEST(Schedule, HalfAFrameRoundsUp) {
    Timing timing;
    timing.fps = {25, 1};
    timing.period = 0.58;  // 14.5 frames, but 14.499999999999998 as a product of doubles
    EXPECT_EQ(make_schedule(timing, Formulas::kCorrected, {})->frames, 15);
    timing.period = 0.579;
    EXPECT_EQ(make_schedule(timing, Formulas::kCorrected, {})->frames, 14);
}

TEST(Schedule, FramesPerSecondMayBeAFraction) {
    Timing timing;
    timing.fps = {24000, 1001};
    timing.period = 1.001;
    const Result<Schedule> schedule = make_schedule(timing, Formulas::kCorrected, {});
    ASSERT_TRUE(schedule);
    EXPECT_EQ(schedule->frames, 24);
    EXPECT_NEAR(schedule->period, 1.001, 1e-15);
    EXPECT_EQ(schedule->fps, (FrameRate{24000, 1001}));
}

TEST(FrameRate, IsTheNearestToAMillionth) {
    EXPECT_EQ(to_frame_rate(24), (FrameRate{24, 1}));
    EXPECT_EQ(to_frame_rate(29.97), (FrameRate{2997, 100}));
    EXPECT_EQ(to_frame_rate(12.5), (FrameRate{25, 2}));
    EXPECT_NEAR(to_frame_rate(23.976023976).value(), 24000.0 / 1001, 1e-6);
    for (const double bad : {0.0, -24.0, kNaN, 1e300, 1e-9}) EXPECT_EQ(to_frame_rate(bad), (FrameRate{0, 1})) << bad;
}

TEST(PictureAt, FollowsTheHoldsCycleAfterCycle) {
    const Result<Schedule> schedule = make_schedule({}, Formulas::kCorrected, {});
    const std::vector<int> wanted{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5};
    for (int frame = 0; frame < 44; ++frame)
        EXPECT_EQ(picture_at(*schedule, frame), wanted[static_cast<std::size_t>(frame % 11)]) << frame;
}

TEST(PicturePhase, IsEvenAndTheSameNumberAWholeCycleLater) {
    for (const Sampling sampling : {Sampling::kUniform, Sampling::kByFrame}) {
        Timing timing;
        timing.sampling = sampling;
        const Result<Schedule> schedule = make_schedule(timing, Formulas::kCorrected, {});
        for (int n = 0; n < 6; ++n) {
            const double wanted = sampling == Sampling::kUniform ? 2 * kPi * n / 6 : 2 * kPi * (2 * n) / 11;
            EXPECT_NEAR(picture_phase(*schedule, n), wanted, 1e-15) << n;
            for (const int cycle : {-2, -1, 1, 1000}) {
                const double later = picture_phase(*schedule, n + 6 * cycle);
                EXPECT_EQ(std::bit_cast<std::uint64_t>(later),
                          std::bit_cast<std::uint64_t>(picture_phase(*schedule, n)))
                    << n;
                EXPECT_EQ(picture_phase(*schedule, n, 1, 6 * cycle), picture_phase(*schedule, n)) << n;
            }
        }
    }
}

TEST(PicturePhase, RunsAheadByWholePictures) {
    const Result<Schedule> schedule = make_schedule({}, Formulas::kCorrected, {});
    for (int n = 0; n < 6; ++n) {
        for (int shift = -7; shift <= 7; ++shift)
            EXPECT_EQ(picture_phase(*schedule, n, 1, shift), picture_phase(*schedule, n + shift));
    }
}

TEST(PicturePhase, TurnsOnceForEveryCycle) {
    for (const Sampling sampling : {Sampling::kUniform, Sampling::kByFrame}) {
        Timing timing;
        timing.sampling = sampling;
        const Result<Schedule> schedule = make_schedule(timing, Formulas::kCorrected, {});
        for (int n = 0; n < 6; ++n) {
            const double once = picture_phase(*schedule, n), twice = picture_phase(*schedule, n, 2);
            EXPECT_NEAR(std::cos(twice), std::cos(2 * once), 1e-14) << n;
            EXPECT_NEAR(std::sin(twice), std::sin(2 * once), 1e-14) << n;
            EXPECT_TRUE(twice >= 0 && twice < 2 * kPi) << n;
        }
    }
}

TEST(Schedule, RefusesWithCodeAndField) {
    const struct {
        const char* name;
        std::function<void(Timing&)> change;
        ErrorCode code;
        const char* field;
    } cases[] = {
        {"period not a number", [](Timing& t) { t.period = kNaN; }, ErrorCode::kNotFinite, "/period"},
        {"no period", [](Timing& t) { t.period = 0; }, ErrorCode::kOutOfRange, "/period"},
        {"period too long", [](Timing& t) { t.period = 61; }, ErrorCode::kOutOfRange, "/period"},
        {"less than half a frame", [](Timing& t) { t.period = 0.02; }, ErrorCode::kTooFew, "/period"},
        {"no frames per second",
         [](Timing& t) {
             t.fps = {0, 1};
         },
         ErrorCode::kOutOfRange, "/fps"},
        {"negative frames per second",
         [](Timing& t) {
             t.fps = {-24, -1};
         },
         ErrorCode::kOutOfRange, "/fps"},
        {"fraction without denominator",
         [](Timing& t) {
             t.fps = {24, 0};
         },
         ErrorCode::kOutOfRange, "/fps"},
        {"too many frames per second",
         [](Timing& t) {
             t.fps = {241, 1};
         },
         ErrorCode::kOutOfRange, "/fps"},
        {"too few frames per second",
         [](Timing& t) {
             t.fps = {999, 1000};
         },
         ErrorCode::kOutOfRange, "/fps"},
        {"no hold", [](Timing& t) { t.hold = 0; }, ErrorCode::kOutOfRange, "/hold"},
        {"hold too long", [](Timing& t) { t.hold = 25; }, ErrorCode::kOutOfRange, "/hold"},
        {"too many frames",
         [](Timing& t) {
             t.fps = {240, 1}, t.period = 7;
         },
         ErrorCode::kTooMany, "/period"},
        {"too many pictures", [](Timing& t) { t.period = 50.0 / 24; }, ErrorCode::kTooMany, "/period"},
    };
    for (const auto& wrong : cases) {
        Timing timing;
        wrong.change(timing);
        EXPECT_TRUE(is_refused(make_schedule(timing, Formulas::kCorrected, {}), wrong.code, wrong.field)) << wrong.name;
    }
}

TEST(Schedule, ThreeToEightPicturesAreUsual) {
    for (int pictures = 1; pictures <= 12; ++pictures)
        EXPECT_EQ(is_usual_picture_count(pictures), pictures >= 3 && pictures <= 8);
}

}  // namespace
}  // namespace tuftwave
