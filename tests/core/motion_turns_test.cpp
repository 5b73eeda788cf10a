#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "moving_chains.hpp"
#include "support.hpp"
#include "tuftwave/motion.hpp"

namespace tuftwave {
namespace {

using test::all_motions;
using test::are_near;
using test::hanging;
using test::kPictures;
using test::moved;
using test::Random;
using test::with_outward;
using test::with_rest_rotations;

TEST(ModelTurns, CarryTheRestBonesIntoEachPicture) {
    Random random(21);
    for (const Motion& motion : all_motions()) {
        const Chain chain = with_rest_rotations(with_outward(hanging()), [&] { return random.rotation(); });
        const ChainMotion all = moved(chain, motion);
        const std::vector<Quat> turns = model_turns(chain, all.rotations);
        const std::size_t nodes = chain.nodes.size();
        ASSERT_EQ(turns.size(), kPictures * nodes);
        for (std::size_t n = 0; n < kPictures; ++n) {
            const auto wanted = node_positions(chain, std::span(all.rotations).subspan(n * nodes, nodes));
            std::vector<Vec3> places{chain.nodes[0]};
            for (std::size_t i = 0; i + 1 < nodes; ++i)
                places.push_back(places[i] + rotated(turns[n * nodes + i], chain.nodes[i + 1] - chain.nodes[i]));
            EXPECT_TRUE(are_near(places, wanted, 1e-14)) << "seed 21, picture " << n;
        }
    }
}

TEST(ModelTurns, KnowNothingOfRestRotations) {
    Random random(22);
    const Chain plain = hanging(), turned = with_rest_rotations(plain, [&] { return random.rotation(); });
    const auto wanted = model_turns(plain, moved(plain, {}).rotations);
    const auto turns = model_turns(turned, moved(turned, {}).rotations);
    for (std::size_t at = 0; at < wanted.size(); ++at)
        EXPECT_NEAR(std::abs(dot(turns[at], wanted[at])), 1, 1e-14) << "seed 22, node " << at;
}

TEST(ModelTurns, AreUnitAndDoNotFlipTheirSign) {
    Random random(23);
    Motion motion;
    motion.wave.amplitude = 20;  // turns of more than half a circle between root and tip
    for (int i = 0; i < 50; ++i) {
        const Chain chain = with_rest_rotations(hanging(), [&] { return random.rotation(); });
        const auto turns = model_turns(chain, moved(chain, motion).rotations);
        const std::size_t nodes = chain.nodes.size();
        for (std::size_t at = 0; at < turns.size(); ++at) {
            ASSERT_NEAR(dot(turns[at], turns[at]), 1, 1e-14) << at;
            ASSERT_GE(at < nodes ? turns[at].w : dot(turns[at], turns[at - nodes]), 0) << "seed 23, turn " << at;
        }
    }
}

TEST(ModelTurns, ARestPoseIsNotTurnedAndATipTurnsAsItsBone) {
    const Chain chain = with_rest_rotations(hanging(), [random = Random(24)]() mutable { return random.rotation(); });
    Motion still;
    still.wave.amplitude = 0;
    for (const Quat& turn : model_turns(chain, moved(chain, still).rotations)) EXPECT_NEAR(turn.w, 1, 1e-14);
    const auto turns = model_turns(chain, moved(chain, {}).rotations);
    for (std::size_t tip = chain.nodes.size() - 1; tip < turns.size(); tip += chain.nodes.size())
        EXPECT_NEAR(std::abs(dot(turns[tip], turns[tip - 1])), 1, 1e-14);
}

}  // namespace
}  // namespace tuftwave
