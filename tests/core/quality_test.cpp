#include "tuftwave/quality.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "support.hpp"

namespace tuftwave {
namespace {

/// A hair of equal bones along +X, its rest rotations all identity.
Chain straight_chain(const int bones) {
    Chain chain;
    for (int i = 0; i <= bones; ++i) chain.nodes.push_back({0.3 * i / bones, 0, 0});
    chain.rest_rotations.resize(chain.nodes.size());
    return chain;
}

TEST(TipCrossings, ThePapersExampleIsAFigureOfEight) {
    for (const double exponent : {0.5, 1.0, 2.0}) {
        for (const int bones : {2, 4, 6, 8, 16, 64}) {
            Wave wave;
            wave.tip_exponent = exponent;
            EXPECT_EQ(tip_crossings(wave, bones), 1) << bones << " bones, exponent " << exponent;
        }
    }
}

TEST(TipCrossings, AWaveTowardsTheRootIsAFigureOfEightToo) {
    Wave wave;
    wave.spatial_period = -1;
    EXPECT_EQ(tip_crossings(wave, 6), 1);
}

TEST(TipCrossings, WithoutAmplitudeThereAreNone) {
    Wave wave;
    wave.amplitude = 0;
    for (const int bones : {1, 2, 6}) EXPECT_EQ(tip_crossings(wave, bones), 0);
}

// The polygon of a path that runs back on itself crosses itself at every step, if one counts carelessly.
TEST(TipCrossings, APathToAndFroHasNone) {
    for (const double amplitude : {0.2, 0.8, 3.0, 100.0}) {
        Wave wave;
        wave.amplitude = amplitude;
        EXPECT_EQ(tip_crossings(wave, 1), 0) << "one bone, amplitude " << amplitude;
    }
    for (const int bones : {2, 6, 64}) {
        Wave wave;
        wave.spatial_period = 100;  // all of the hair in one phase
        EXPECT_EQ(tip_crossings(wave, bones), 0) << bones << " bones";
    }
}

TEST(ChordAngles, StayWithinARightAngle) {
    test::Random random(2);
    const Result<Schedule> schedule = make_schedule({}, Formulas::kCorrected, {});
    for (int i = 0; i < 200; ++i) {
        Motion motion;
        motion.mode = Mode::kAbsolute;
        motion.wave = {random.between(-100, 100), random.between(0.05, 3), random.between(0.05, 3),
                       random.between(0.05, 8)};
        const std::vector<Chain> chains{straight_chain(1 + random.below(12))};
        const auto moved = move_chains(chains, motion, *schedule, {}, InOrder{}, {});
        ASSERT_TRUE(moved);
        const std::size_t nodes = chains[0].nodes.size();
        for (std::size_t n = 0; n < 6; ++n) {
            const auto places = node_positions(chains[0], std::span((*moved)[0].rotations).subspan(n * nodes, nodes));
            for (std::size_t k = 1; k < nodes; ++k)
                ASSERT_GE(places[k].x, places[k - 1].x - 1e-12) << "seed 2, case " << i;
        }
    }
}

TEST(LargestStep, OfAChainAtRestIsNothing) {
    const Chain chain = straight_chain(4);
    ChainMotion still;
    still.rotations.resize(6 * chain.nodes.size());
    EXPECT_EQ(largest_step(chain, still), 0);
}

TEST(LargestStep, IsTheTurnInModelSpaceFromTheLastPictureToTheFirstToo) {
    const Chain chain = straight_chain(2);
    const Quat turn = turn_about({0, 0, 1}, 0.3);
    ChainMotion motion;  // three pictures of three nodes: the root turns by 0.3, then both bones do, then by 0.3 again
    motion.rotations = {turn, {}, {}, turn, turn, {}, turn * turn, turn, {}};
    EXPECT_NEAR(largest_step(chain, motion), 0.6, 1e-12);  // the second bone is at 0.3, 0.6, 0.9 and back at 0.3
    motion.rotations.resize(6);
    EXPECT_NEAR(largest_step(chain, motion), 0.3, 1e-12);
}

TEST(LargestStep, DoesNotCareAboutAQuaternionsSign) {
    const Chain chain = straight_chain(1);
    const Quat turn = turn_about({0, 0, 1}, 0.2);
    EXPECT_NEAR(largest_step(chain, {0, {{}, {}, -turn, {}}}), 0.2, 1e-12);
}

}  // namespace
}  // namespace tuftwave
