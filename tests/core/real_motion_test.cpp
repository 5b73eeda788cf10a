// Motions that others animated by hand, bone by bone. What is asserted is that a wave says more about them than a still
// picture; the table that is printed says how much.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "drawn_waves.hpp"

namespace tuftwave {
namespace {

using namespace test;

struct RealMotion {
    std::string file, animation;
    Drawing drawing;
};

Vec3 point_of(const nlohmann::json& point) { return {point[0].get<double>(), point[1].get<double>(), 0}; }

std::vector<RealMotion> real_motions() {
    std::vector<RealMotion> motions;
    for (const char* const name : {"raptor_tail", "spineboy_hair", "mixmatch_hair"}) {
        std::ifstream file(std::string(TUFTWAVE_TEST_DATA "/motion/motion_") + name + ".json");
        for (const nlohmann::json& chain : nlohmann::json::parse(file)) {
            RealMotion motion{name, chain["animation"], {chain["bones"][0], {}, {}}};
            for (const nlohmann::json& picture : chain["pictures"]) {
                Line line;
                for (const nlohmann::json& point : picture["points"]) line.push_back(point_of(point));
                motion.drawing.pictures.push_back(line);
            }
            motions.push_back(motion);
        }
    }
    return motions;
}

/// The wind along which the chain lies in the mean.
FitSettings settings_along(const Drawing& drawing) {
    FitSettings settings;
    settings.wind = {};
    for (const Line& line : drawing.pictures) settings.wind = settings.wind + (line.back() - line.front());
    settings.up = cross(Vec3{0, 0, 1}, settings.wind);
    return settings;
}

TEST(RealMotions, AreNearerToAFittedWaveThanToAStillPicture) {
    int fits = 0, much_nearer = 0;
    for (const RealMotion& motion : real_motions()) {
        if (motion.drawing.pictures[0].size() < 3) continue;
        const Fit fit = fitted(motion.drawing, settings_along(motion.drawing));
        std::printf("%-13s %-10s %-6s fit %5.2f deg %5.2f %%  still %5.2f deg %5.2f %%  waves per loop %d, steps %d\n",
                    motion.file.c_str(), motion.animation.c_str(), motion.drawing.name.c_str(),
                    fit.error.mean.angle / kRadiansPerDegree, 100 * fit.error.mean.position,
                    fit.still.mean.angle / kRadiansPerDegree, 100 * fit.still.mean.position, fit.cycles, fit.steps);
        EXPECT_TRUE(fit.is_complete);
        EXPECT_FALSE(has(fit, FitWarning::kNoBetterThanStill));
        EXPECT_LT(fit.error.mean.position, 0.6 * fit.still.mean.position);
        EXPECT_LT(fit.error.mean.angle, 0.6 * fit.still.mean.angle);
        ++fits;
        if (fit.error.mean.angle < fit.still.mean.angle / 4) ++much_nearer;
    }
    EXPECT_EQ(fits, 9);
    EXPECT_GE(much_nearer, 5);
}

TEST(RealMotions, OfATailOfTenBonesAreAWaveTwicePerStep) {
    // The walk is a cycle of two steps, and the tail beats with each.
    const RealMotion tail = real_motions()[0];
    ASSERT_EQ(tail.drawing.pictures[0].size(), 11U);
    FitSettings settings = settings_along(tail.drawing);
    const Fit fit = fitted(tail.drawing, settings);
    EXPECT_EQ(fit.cycles, 2);
    EXPECT_GT(fit.wave.spatial_period, 0);  // from root to tip
    EXPECT_LT(fit.error.mean.angle, 4 * kRadiansPerDegree);
    EXPECT_GT(fit.still.mean.angle, 20 * kRadiansPerDegree);
    settings.cycles = 1;
    EXPECT_GT(fitted(tail.drawing, settings).error.mean.angle, 20 * kRadiansPerDegree);
}

TEST(RealMotions, OfSingleBonesCanOnlyBeHeldStill) {
    for (const RealMotion& motion : real_motions()) {
        if (motion.drawing.pictures[0].size() != 2) continue;
        EXPECT_TRUE(is_refused(check_drawings({&motion.drawing, 1}, {}), ErrorCode::kTooFew, "/0/pictures/0"));
        const MotionError still = still_error(motion.drawing.pictures, mean_length(motion.drawing.pictures));
        std::printf("%-13s %-10s %-20s still %5.2f deg %5.2f %%\n", motion.file.c_str(), motion.animation.c_str(),
                    motion.drawing.name.c_str(), still.mean.angle / kRadiansPerDegree, 100 * still.mean.position);
        EXPECT_GT(still.mean.angle, kRadiansPerDegree);
    }
}

}  // namespace
}  // namespace tuftwave
