#include "tuftwave/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stop_token>
#include <vector>

#include "drawn_waves.hpp"

namespace tuftwave {
namespace {

using namespace test;

constexpr Mode kModes[] = {Mode::kRelative, Mode::kAbsolute};

/// Whether a fit found the wave that was drawn; says what it found instead.
testing::AssertionResult found(const KnownWave& known, const Fit& fit, const double tolerance) {
    const Wave& drawn = known.motion.wave;
    const Wave& wave = fit.wave;
    const double turn = (fit.phase - known.chain.phase) / (2 * kPi);
    for (const double apart : {wave.amplitude - drawn.amplitude, wave.lightness - drawn.lightness,
                               wave.spatial_period - drawn.spatial_period, wave.tip_exponent - drawn.tip_exponent,
                               2 * kPi * (turn - std::round(turn))}) {
        if (std::abs(apart) <= tolerance) continue;
        return testing::AssertionFailure()
               << "a " << wave.amplitude << " s " << wave.lightness << " k " << wave.spatial_period << " p "
               << wave.tip_exponent << " phase " << fit.phase << " instead of " << drawn.amplitude << " "
               << drawn.lightness << " " << drawn.spatial_period << " " << drawn.tip_exponent << " "
               << known.chain.phase;
    }
    return testing::AssertionSuccess();
}

TEST(FitWaves, FindThePapersWaveOnAStraightChain) {
    for (const Mode mode : kModes) {
        const KnownWave known = known_wave({}, mode, straight({1, 0, 0}, 8), 0, 6);
        const Fit fit = fitted(known.drawing, fit_settings(mode));
        EXPECT_TRUE(found(known, fit, 1e-6));
        EXPECT_TRUE(fit.is_complete);
        EXPECT_TRUE(fit.warnings.empty());
        EXPECT_LT(fit.error.mean.position, 1e-9);
        EXPECT_GT(fit.still.mean.position, 0.01);
    }
}

TEST(FitWaves, FindAnyWaveThatWasDrawnWithoutNoise) {
    Random random(5);
    for (int round = 0; round < 400; ++round) {
        const Mode mode = kModes[round % 2];
        const int bones = 2 + random.below(9), pictures = 3 + random.below(6);
        // Two bones in three pictures, less their means, say four angles: too few for five unknowns.
        if (mode == Mode::kRelative && bones * (pictures - 1) < 5) continue;
        const Chain chain = uneven_chain(random, bones, 0.4);
        KnownWave known = known_wave(any_wave(random, bones), mode, chain, random.between(-3, 3), pictures);
        if (random.below(2) == 0) known.drawing.rest = chain.nodes;
        const Fit fit = fitted(known.drawing, fit_settings(mode));
        EXPECT_TRUE(found(known, fit, 1e-6)) << "round " << round << ", " << bones << " bones, " << pictures;
        EXPECT_TRUE(fit.is_complete) << round;
    }
}

TEST(FitWaves, FindTheRestPoseThatTheMotionWasAddedTo) {
    const KnownWave known = known_wave({}, Mode::kRelative, hanging(), 0.7, 6);
    EXPECT_TRUE(are_near(fitted(known.drawing, fit_settings(Mode::kRelative)).rest, known.chain.nodes, 1e-9));
}

TEST(FitWaves, AnswerWhatMovesTheChainAsDrawn) {
    Random random(6);
    for (const Mode mode : kModes) {
        KnownWave known = known_wave(any_wave(random, 5), mode, uneven_chain(random, 5, 0.4), 1, 5);
        add_noise(known.drawing.pictures, 0.002, random);
        const Fit fit = fitted(known.drawing, fit_settings(mode));
        Motion motion = known.motion;
        motion.wave = fit.wave;
        Chain chain = chain_of(fit.rest);
        chain.phase = fit.phase;
        double whole = 0;
        for (std::size_t i = 1; i < fit.rest.size(); ++i) whole += length(fit.rest[i] - fit.rest[i - 1]);
        const auto error = measure_error(pictures(chain, motion), known.drawing.pictures, whole);
        EXPECT_NEAR(error->mean.position, fit.error.mean.position, 1e-12);
        EXPECT_NEAR(error->mean.angle, fit.error.mean.angle, 1e-12);
        EXPECT_LT(fit.error.mean.position, fit.still.mean.position / 2);
    }
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

TEST(FitWaves, StayNearUnderNoise) {
    // 2 % of the chain's length on every node of 8 segments in 6 pictures; the bounds are the figures of the method.
    constexpr double kLength = 0.3;
    Random random(7);
    std::vector<double> a, s, k, p, pose;
    for (int round = 0; round < 300; ++round) {
        KnownWave known = known_wave({}, Mode::kAbsolute, straight({1, 0, 0}, 8), random.between(-3, 3), 6);
        const std::vector<Line> clean = known.drawing.pictures;
        add_noise(known.drawing.pictures, 0.02 * kLength, random);
        known.drawing.rest = known.chain.nodes;
        const Fit fit = fitted(known.drawing, fit_settings(Mode::kAbsolute));
        a.push_back(std::abs(fit.wave.amplitude - 0.8));
        s.push_back(std::abs(fit.wave.lightness - 1.2));
        k.push_back(std::abs(fit.wave.spatial_period - 1));
        p.push_back(std::abs(fit.wave.tip_exponent - 1));
        KnownWave refound = known_wave(fit.wave, Mode::kAbsolute, known.chain, fit.phase, 6);
        pose.push_back(measure_error(refound.drawing.pictures, clean, kLength)->mean.angle / kRadiansPerDegree);
        EXPECT_TRUE(fit.is_complete);
        EXPECT_FALSE(has(fit, FitWarning::kDroopNotIdentifiable));
    }
    EXPECT_LT(median(a), 0.045);
    EXPECT_LT(median(s), 0.04);
    EXPECT_LT(median(k), 0.035);
    EXPECT_LT(median(p), 0.055);
    EXPECT_LT(median(pose), 1.05);
}

TEST(FitWaves, SayWhenNoiseHidesTheDroopOfARelativeMotion) {
    Random random(8);
    int warned = 0;
    for (int round = 0; round < 50; ++round) {
        KnownWave known = known_wave({0.3, 1, 1.2, 1}, Mode::kRelative, straight({1, 0, 0}, 8), 0, 6);
        add_noise(known.drawing.pictures, 0.02 * 0.3, random);
        known.drawing.rest = known.chain.nodes;
        const Fit fit = fitted(known.drawing, fit_settings(Mode::kRelative));
        if (!has(fit, FitWarning::kDroopNotIdentifiable)) continue;
        ++warned;
        EXPECT_NEAR(fit.wave.amplitude / fit.wave.lightness, 0.25, 0.1);  // a / s is known all the same
        EXPECT_LT(fit.error.mean.position, fit.still.mean.position);
    }
    EXPECT_GT(warned, 40);
}

TEST(FitWaves, OfAWaveWithoutDroopKeepItsSwing) {
    // A straight line's wave with a lightness of 100, which is as little droop as there can be.
    const KnownWave known = known_wave({50, 1, 100, 1}, Mode::kAbsolute, straight({1, 0, 0}, 8), 0, 6);
    std::vector<Line> raised = known.drawing.pictures;
    Drawing drawing{"", {}, {}};
    // Mirrored and half a cycle later the droop is the opposite: between the two there is none.
    for (std::size_t n = 0; n < raised.size(); ++n) {
        Line line = raised[n];
        const Line& other = raised[(n + 3) % raised.size()];
        for (std::size_t i = 0; i < line.size(); ++i) line[i].y = (line[i].y + 2 * line[0].y - other[i].y) / 2;
        drawing.pictures.push_back(line);
    }
    drawing.rest = known.chain.nodes;
    const Fit fit = fitted(drawing, fit_settings(Mode::kAbsolute));
    EXPECT_TRUE(has(fit, FitWarning::kDroopNotIdentifiable));
    EXPECT_NEAR(fit.wave.amplitude / fit.wave.lightness, 0.5, 0.01);
    EXPECT_NEAR(fit.wave.spatial_period, 1, 0.01);
    EXPECT_LT(fit.error.mean.position, 0.005);
}

TEST(FitWaves, OfTwoPicturesRunRootToTipAndSaySo) {
    for (const double k : {1.3, -1.3}) {
        const KnownWave known = known_wave({0.8, k, 1.2, 1}, Mode::kAbsolute, straight({1, 0, 0}, 6), 0.4, 2);
        const Fit fit = fitted(known.drawing, fit_settings(Mode::kAbsolute));
        EXPECT_TRUE(has(fit, FitWarning::kTwoPictures));
        EXPECT_NEAR(fit.wave.spatial_period, 1.3, 1e-6);
        EXPECT_LT(fit.error.mean.position, 1e-9);
    }
}

TEST(FitWaves, OfPicturesThatDoNotDifferAreStill) {
    const Drawing drawing{"", std::vector<Line>(4, hanging().nodes), {}};
    const Fit relative = fitted(drawing, fit_settings(Mode::kRelative));
    EXPECT_TRUE(has(relative, FitWarning::kStill));
    EXPECT_EQ(relative.wave.amplitude, 0);
    EXPECT_LT(relative.error.mean.position, 1e-12);
    const Fit absolute = fitted(drawing, fit_settings(Mode::kAbsolute));
    EXPECT_TRUE(has(absolute, FitWarning::kStill));
    EXPECT_FALSE(check_wave(absolute.wave, {}));
    const Drawing straight_drawing{"", std::vector<Line>(4, straight({1, 0, 0}, 3).nodes), {}};
    EXPECT_LT(fitted(straight_drawing, fit_settings(Mode::kAbsolute)).error.mean.position, 1e-9);
}

TEST(FitWaves, OfScribblesEndAndStayWithinTheLimits) {
    Random random(9);
    for (int round = 0; round < 200; ++round) {
        const Mode mode = kModes[round % 2];
        const int nodes = 3 + random.below(8), pictures = 2 + random.below(8);
        Drawing drawing;
        for (int n = 0; n < pictures; ++n) {
            Line line;
            for (int i = 0; i < nodes; ++i) line.push_back(random.in_cube(random.below(5) == 0 ? 1e6 : 1));
            drawing.pictures.push_back(line);
        }
        if (random.below(3) == 0) {  // a rest pose of another size altogether
            drawing.rest.emplace();
            for (int i = 0; i < nodes; ++i) drawing.rest->push_back(random.in_cube(random.below(2) == 0 ? 1e-8 : 1e6));
        }
        const Fit fit = fitted(drawing, fit_settings(mode));
        EXPECT_FALSE(check_wave(fit.wave, {})) << round;
        EXPECT_LE(fit.steps, FitSettings{}.steps);
        EXPECT_GT(fit.steps, 0);
        EXPECT_TRUE(std::isfinite(fit.error.mean.position)) << round;
        EXPECT_LE(std::abs(fit.phase), kPi);
        for (const Vec3& node : fit.rest) EXPECT_TRUE(is_finite(node));
    }
}

TEST(FitWaves, TakeNoMoreStepsThanTheyMay) {
    Random random(10);
    KnownWave known = known_wave({}, Mode::kAbsolute, straight({1, 0, 0}, 8), 0, 6);
    add_noise(known.drawing.pictures, 0.006, random);
    FitSettings settings = fit_settings(Mode::kAbsolute);
    const Fit whole = fitted(known.drawing, settings);
    ASSERT_TRUE(whole.is_complete);
    for (const int steps : {1, 5, 20}) {
        settings.steps = steps;
        const Fit cut = fitted(known.drawing, settings);
        EXPECT_EQ(cut.steps, steps);
        EXPECT_FALSE(cut.is_complete);
        EXPECT_LT(cut.error.mean.position, cut.still.mean.position);  // the best so far is already something
        EXPECT_GE(cut.error.mean.position, 0.9 * whole.error.mean.position);
    }
    settings.steps = whole.steps;
    EXPECT_TRUE(fitted(known.drawing, settings).is_complete);
}

TEST(FitWaves, StopWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    const KnownWave known = known_wave({}, Mode::kAbsolute, straight({1, 0, 0}, 8), 0, 6);
    const auto fits = fit_waves(std::span(&known.drawing, 1), fit_settings(Mode::kAbsolute), nullptr, {}, InOrder(),
                                stop.get_token());
    ASSERT_TRUE(fits);
    EXPECT_FALSE((*fits)[0].is_complete);
    EXPECT_EQ((*fits)[0].steps, 0);
}

TEST(FitWaves, KnowWhenThePicturesWereDrawn) {
    KnownWave known = known_wave({}, Mode::kAbsolute, straight({1, 0, 0}, 8), 0.5, 5);
    known.motion.timing = {0.45, {}, 3, ShortHolds::kLast, Sampling::kByFrame};  // 11 frames as 3, 3, 3, 2
    known.drawing.pictures = pictures(known.chain, known.motion);
    const Schedule schedule = schedule_of(known.motion.timing);
    EXPECT_TRUE(found(known, fitted(known.drawing, fit_settings(Mode::kAbsolute), &schedule), 1e-6));
    EXPECT_FALSE(found(known, fitted(known.drawing, fit_settings(Mode::kAbsolute)), 1e-3));
}

TEST(FitWaves, FindHowManyWavesPassPerLoop) {
    Random random(12);
    for (const int cycles : {1, 2, 3}) {
        KnownWave known = known_wave({}, Mode::kAbsolute, straight({1, 0, 0}, 8), 0.5, 8);
        known.chain.cycles = cycles;
        known.drawing.pictures = pictures(known.chain, known.motion);
        const Fit exact = fitted(known.drawing, fit_settings(Mode::kAbsolute));
        EXPECT_EQ(exact.cycles, cycles);
        EXPECT_TRUE(found(known, exact, 1e-6));
        add_noise(known.drawing.pictures, 0.006, random);
        EXPECT_EQ(fitted(known.drawing, fit_settings(Mode::kAbsolute)).cycles, cycles);
        FitSettings asked = fit_settings(Mode::kAbsolute);
        asked.cycles = cycles == 1 ? 2 : 1;
        const Fit other = fitted(known.drawing, asked);
        EXPECT_EQ(other.cycles, *asked.cycles);
        EXPECT_GT(other.error.mean.position, 2 * exact.error.mean.position);
    }
}

TEST(FitWaves, AreTheSameInAnyOrder) {
    Random random(11);
    std::vector<Drawing> drawings;
    for (int i = 0; i < 7; ++i) {
        KnownWave known = known_wave(any_wave(random, 5), Mode::kRelative, uneven_chain(random, 5, 0.4), 1, 5);
        add_noise(known.drawing.pictures, 0.002, random);
        drawings.push_back(known.drawing);
    }
    const FitSettings settings = fit_settings(Mode::kRelative);
    const auto in_order = fit_waves(drawings, settings, nullptr, {}, InOrder(), {});
    const LastFirst last_first;
    const EvenFirst even_first;
    for (const ForEach* order : std::initializer_list<const ForEach*>{&last_first, &even_first}) {
        const auto other = fit_waves(drawings, settings, nullptr, {}, *order, {});
        for (std::size_t i = 0; i < drawings.size(); ++i) {
            EXPECT_EQ(std::bit_cast<std::uint64_t>((*other)[i].wave.amplitude),
                      std::bit_cast<std::uint64_t>((*in_order)[i].wave.amplitude));
            EXPECT_EQ(std::bit_cast<std::uint64_t>((*other)[i].phase),
                      std::bit_cast<std::uint64_t>((*in_order)[i].phase));
        }
    }
}

TEST(FitWaves, RefuseWhatTheyCannotUse) {
    const Drawing drawing = known_wave({}, Mode::kAbsolute, straight({1, 0, 0}, 4), 0, 6).drawing;
    const auto fit = [&](const FitSettings& settings, const Schedule* schedule = nullptr) {
        return fit_waves(std::span(&drawing, 1), settings, schedule, {}, InOrder(), {});
    };
    FitSettings settings;
    settings.wind = {0, 2, 0};
    EXPECT_TRUE(is_refused(fit(settings), ErrorCode::kDegenerate, "/wind"));
    settings.wind = {0, 0, 0};
    EXPECT_TRUE(is_refused(fit(settings), ErrorCode::kDegenerate, "/wind"));
    settings = {};
    settings.up = {0, std::numeric_limits<double>::infinity(), 0};
    EXPECT_TRUE(is_refused(fit(settings), ErrorCode::kNotFinite, "/up/1"));
    settings = {};
    settings.steps = 0;
    EXPECT_TRUE(is_refused(fit(settings), ErrorCode::kOutOfRange, "/steps"));
    settings = {};
    settings.cycles = 12;
    EXPECT_TRUE(is_refused(fit(settings), ErrorCode::kOutOfRange, "/cycles"));
    settings.cycles = 3;  // in 6 pictures, two of each wave: up and down
    EXPECT_TRUE(is_refused(fit(settings), ErrorCode::kConflict, "/cycles"));
    settings.cycles = 2;
    EXPECT_TRUE(fit(settings));
    const Schedule schedule = schedule_of(timing_of(5));
    EXPECT_TRUE(is_refused(fit({}, &schedule), ErrorCode::kConflict, "/drawn/0/pictures"));
}

TEST(CheckDrawings, RefusesWithCodeAndField) {
    const Drawing good = known_wave({}, Mode::kAbsolute, straight({1, 0, 0}, 4), 0, 6).drawing;
    const auto check = [&](auto change) {
        Drawing drawing = good;
        change(drawing);
        return check_drawings(std::vector<Drawing>{good, drawing}, {});
    };
    EXPECT_FALSE(check([](Drawing&) {}));
    EXPECT_TRUE(is_refused(check_drawings({}, {}), ErrorCode::kTooFew, ""));
    EXPECT_TRUE(is_refused(check([](Drawing& d) { d.pictures.resize(1); }), ErrorCode::kTooFew, "/1/pictures"));
    EXPECT_TRUE(is_refused(check([&](Drawing& d) { d.pictures.resize(25, good.pictures[0]); }), ErrorCode::kTooMany,
                           "/1/pictures"));
    EXPECT_TRUE(is_refused(check([](Drawing& d) { d.pictures[2].pop_back(); }), ErrorCode::kConflict, "/1/pictures/2"));
    const auto cut_to_one_segment = [](Drawing& d) {
        for (Line& line : d.pictures) line.resize(2);
    };
    EXPECT_TRUE(is_refused(check(cut_to_one_segment), ErrorCode::kTooFew, "/1/pictures/0"));
    EXPECT_TRUE(
        is_refused(check([](Drawing& d) { d.pictures[1][2].x = 2e6; }), ErrorCode::kOutOfRange, "/1/pictures/1/2/0"));
    EXPECT_TRUE(
        is_refused(check([](Drawing& d) { d.pictures.assign(6, Line(5)); }), ErrorCode::kDegenerate, "/1/pictures"));
    EXPECT_TRUE(is_refused(check([](Drawing& d) { d.rest = Line(4); }), ErrorCode::kConflict, "/1/rest"));
    EXPECT_TRUE(is_refused(check([](Drawing& d) { d.rest = Line(5); }), ErrorCode::kDegenerate, "/1/rest"));
    EXPECT_TRUE(is_refused(check([](Drawing& d) {
                               d.rest = Line(5, {0, 0, -1e7});
                           }),
                           ErrorCode::kOutOfRange, "/1/rest/0/2"));
    Limits small;
    small.drawn_nodes = 59;  // two drawings of 6 pictures with 5 nodes have 60
    EXPECT_TRUE(is_refused(check_drawings(std::vector<Drawing>{good, good}, small), ErrorCode::kTooMany, ""));
    small.drawn_nodes = 60;
    EXPECT_FALSE(check_drawings(std::vector<Drawing>{good, good}, small));
}

}  // namespace
}  // namespace tuftwave
