#include "gltf/clip_keys.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "gltf/key_times.hpp"

namespace tuftwave::server::gltf {
namespace {

using Pictures = std::vector<std::size_t>;

Schedule schedule_of(double period, FrameRate fps, int hold) {
    Limits roomy;
    roomy.frames = 14'400;
    roomy.pictures = 14'400;
    return *make_schedule({period, fps, hold, ShortHolds::kLast, Sampling::kUniform}, Formulas::kCorrected, roomy);
}

/// A minute at the highest rate, where float32 resolves least of a frame, the paper's timing, and others.
std::vector<Schedule> schedules() {
    return {schedule_of(60, {240, 1}, 1), schedule_of(0.45, {24, 1}, 2), schedule_of(0.8, {24'000, 1'001}, 3),
            schedule_of(2, {12, 1}, 24),  schedule_of(0.05, {24, 1}, 2), schedule_of(60, {1, 1}, 1)};
}

double frame_of(const ClipKeys& keys, std::size_t key, const Schedule& schedule) {
    return static_cast<double>(keys.times[key]) * schedule.fps.value();
}

TEST(ClipKeys, AStepIsAKeyPerPictureAndOneThatClosesTheLoop) {
    const Schedule schedule = schedule_of(0.45, {24, 1}, 2);
    const ClipKeys keys = clip_keys(schedule, Holding::kStep);
    EXPECT_TRUE(keys.is_stepped);
    EXPECT_EQ(keys.times, key_times(schedule));
    EXPECT_EQ(keys.pictures, (Pictures{0, 1, 2, 3, 4, 5, 0}));
}

TEST(ClipKeys, AHeldPictureHasTwoKeysAndChangesAtItsVeryEnd) {
    EXPECT_EQ(clip_keys(schedule_of(0.45, {24, 1}, 2), Holding::kHeld).pictures,
              (Pictures{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 0}));
    for (const Schedule& schedule : schedules()) {
        const ClipKeys keys = clip_keys(schedule, Holding::kHeld);
        const std::vector<float> changes = key_times(schedule);
        EXPECT_FALSE(keys.is_stepped);
        ASSERT_EQ(keys.times.size(), 2 * changes.size() - 1);
        for (std::size_t n = 0; n < changes.size(); ++n) EXPECT_EQ(keys.times[2 * n], changes[n]) << n;
        for (std::size_t key = 1; key < keys.times.size(); ++key) {
            ASSERT_GT(keys.times[key], keys.times[key - 1]) << key;
            if (key % 2 == 0) {
                ASSERT_LT(frame_of(keys, key, schedule) - frame_of(keys, key - 1, schedule), 0.0025) << key;
            }
        }
    }
}

TEST(ClipKeys, EachFrameHasTheKeyOfThePictureOnShow) {
    EXPECT_EQ(clip_keys(schedule_of(0.45, {24, 1}, 2), Holding::kPerFrame).pictures,
              (Pictures{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 0}));
    for (const Schedule& schedule : schedules()) {
        const ClipKeys keys = clip_keys(schedule, Holding::kPerFrame);
        EXPECT_TRUE(keys.is_stepped);
        ASSERT_EQ(keys.times.size(), static_cast<std::size_t>(schedule.frames) + 1);
        EXPECT_EQ(keys.times[0], 0);
        EXPECT_EQ(keys.pictures.back(), 0U);
        for (std::size_t key = 1; key < keys.times.size(); ++key) {
            ASSERT_LT(frame_of(keys, key, schedule), static_cast<double>(key));
            ASSERT_GT(frame_of(keys, key, schedule), static_cast<double>(key) - 0.001);
            if (key + 1 < keys.times.size()) {
                ASSERT_EQ(keys.pictures[key], static_cast<std::size_t>(picture_at(schedule, static_cast<int>(key))))
                    << key;
            }
        }
    }
}

}  // namespace
}  // namespace tuftwave::server::gltf
