#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "moving_chains.hpp"
#include "support.hpp"
#include "tuftwave/fit.hpp"

/// Drawings whose wave is known.
namespace tuftwave::test {

/// A cycle of so many pictures, evenly in time.
inline Timing timing_of(const int pictures) {
    Timing timing;
    timing.period = 2.0 * pictures / 24;
    return timing;
}

/// A motion, a chain, and what an artist who followed it would draw.
struct KnownWave {
    Motion motion;
    Chain chain;
    Drawing drawing;
};

inline KnownWave known_wave(const Wave& wave, const Mode mode, const Chain& chain, const double phase,
                            const int pictures) {
    KnownWave known{motion_in(mode), chain, {}};
    known.motion.wave = wave;
    known.motion.timing = timing_of(pictures);
    known.chain.phase = phase;
    known.drawing.pictures = test::pictures(known.chain, known.motion);
    return known;
}

/// A chain of unequal bones, straight or bent out of every plane.
inline Chain uneven_chain(Random& random, const int bones, const double bend) {
    const Vec3 direction = random.direction();
    std::vector<Vec3> nodes{random.in_cube(1)};
    for (int i = 0; i < bones; ++i)
        nodes.push_back(nodes.back() + random.between(0.03, 0.06) * normalized(direction + random.in_cube(bend)));
    return chain_of(nodes);
}

/// Any wave that so many bones can show, its amplitude and lightness of one sign.
inline Wave any_wave(Random& random, const int bones) {
    Wave wave;
    wave.lightness = random.between(0.5, 2.5);
    wave.amplitude = random.between(0.2, 1.2) * wave.lightness;
    wave.spatial_period = random.between(std::max(0.4, 2.2 / bones), 2.5) * (random.below(3) == 0 ? -1 : 1);
    wave.tip_exponent = random.between(0.4, 2.5);
    return wave;
}

/// Normal deviates near enough: the sum of twelve even ones.
inline double normal(Random& random) {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += random.between(0, 1);
    return sum;
}

/// Moves every node but the root, which the artist knows, within the plane.
inline void add_noise(std::vector<Line>& pictures, const double deviation, Random& random) {
    for (Line& line : pictures) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            const double x = normal(random), y = normal(random);
            line[i] = line[i] + deviation * Vec3{x, y, 0};
        }
    }
}

inline FitSettings fit_settings(const Mode mode) {
    FitSettings settings;
    settings.mode = mode;
    return settings;
}

inline Fit fitted(const Drawing& drawing, const FitSettings& settings, const Schedule* schedule = nullptr) {
    const auto fits = fit_waves(std::span(&drawing, 1), settings, schedule, {}, InOrder(), {});
    EXPECT_TRUE(fits) << (fits ? "" : fits.error().field);
    return fits ? (*fits)[0] : Fit{};
}

inline bool has(const Fit& fit, const FitWarning warning) {
    for (const FitWarning one : fit.warnings) {
        if (one == warning) return true;
    }
    return false;
}

}  // namespace tuftwave::test
