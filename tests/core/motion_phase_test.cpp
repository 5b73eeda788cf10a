#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
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
using test::pictures;
using test::schedule_of;
using test::straight;
using test::with_outward;

TEST(MotionPhase, AWholeCycleAheadIsTheSameBitForBit) {
    Motion motion;
    motion.phase.step = PhaseStep::kPicture;
    Chain chain = hanging();
    const ChainMotion now = moved(chain, motion);
    chain.phase = 2 * kPi;
    EXPECT_EQ(moved(chain, motion).rotations, now.rotations);
    chain.phase = -6 * kPi;
    EXPECT_EQ(moved(chain, motion).rotations, now.rotations);
}

TEST(MotionPhase, SomePicturesAheadShowsTheSamePicturesThatMuchEarlier) {
    for (const PhaseStep step : {PhaseStep::kPicture, PhaseStep::kFree}) {
        for (Motion motion : all_motions()) {
            motion.phase.step = step;
            Chain chain = with_outward(hanging());
            const std::size_t nodes = chain.nodes.size();
            const ChainMotion now = moved(chain, motion);
            for (std::size_t j = 0; j < kPictures; ++j) {
                chain.phase = 2 * kPi * static_cast<double>(j) / kPictures;
                const ChainMotion ahead = moved(chain, motion);
                for (std::size_t at = 0; at < now.rotations.size(); ++at) {
                    const Quat &a = ahead.rotations[at], &b = now.rotations[(at + j * nodes) % now.rotations.size()];
                    if (step == PhaseStep::kPicture) {
                        ASSERT_EQ(a, b) << "ahead by " << j << ", rotation " << at;
                    } else {
                        ASSERT_NEAR(dot(a, b), 1, 1e-12) << "ahead by " << j << ", rotation " << at;
                    }
                }
            }
        }
    }
}

TEST(MotionPhase, TwoCyclesShowEachPictureTwice) {
    Motion motion;
    motion.phase.cycles = 2;
    const ChainMotion all = moved(hanging(), motion);
    const std::size_t half = all.rotations.size() / 2;
    for (std::size_t at = 0; at < half; ++at) EXPECT_EQ(all.rotations[at], all.rotations[at + half]) << at;
    Chain own = hanging();
    own.cycles = 2;
    EXPECT_EQ(moved(own, {}).rotations, all.rotations);
}

TEST(MotionPhase, AGustReachesWhatLiesDownTheWindLater) {
    Motion motion;
    motion.wind = {2, 0, 0};
    motion.phase.gust_wavelength = 0.6;
    const Chain near = straight({0, -1, 0}, 3);
    Chain far = near;
    for (Vec3& node : far.nodes) node.x += 0.2;  // a third of the wavelength: two of six pictures
    const auto first = pictures(near, motion), later = pictures(far, motion);
    for (std::size_t n = 0; n < kPictures; ++n) {
        const Vec3 aside{0.2, 0, 0};
        EXPECT_TRUE(are_near(later[(n + 2) % kPictures].back() - aside, first[n].back(), 1e-12)) << n;
    }
}

TEST(MotionPhase, AGustOverTheLargestDistanceIsStillAPhase) {
    Motion motion;
    motion.phase.gust_wavelength = 1e-3;
    Chain chain = straight({0, -1, 0}, 1);
    for (Vec3& node : chain.nodes) node.x += 1e6 - 1;
    for (const PhaseStep step : {PhaseStep::kFree, PhaseStep::kPicture}) {
        motion.phase.step = step;
        EXPECT_LE(std::abs(moved(chain, motion).phase), 2 * kPi);
    }
}

TEST(MotionPhase, ScatterIsTheSameForASeedAndAnyOrder) {
    const std::vector<Chain> chains(20, hanging());
    Motion motion;
    motion.phase.spread = 1;
    const auto phases = [&](const std::uint64_t seed, const ForEach& for_each) {
        motion.phase.seed = seed;
        std::vector<double> result;
        const auto all = move_chains(chains, motion, schedule_of(), {}, for_each, {});
        for (const ChainMotion& chain : *all) result.push_back(chain.phase);
        return result;
    };
    const std::vector<double> first = phases(1, InOrder{});
    EXPECT_EQ(phases(1, test::LastFirst{}), first);
    EXPECT_EQ(phases(1, test::EvenFirst{}), first);
    EXPECT_NE(phases(2, InOrder{}), first);
    EXPECT_NE(phases(std::uint64_t{1} << 32, InOrder{}), phases(0, InOrder{}));
    for (const double phase : first) EXPECT_TRUE(phase >= 0 && phase < 2 * kPi);
    EXPECT_NE(first[0], first[1]);
}

}  // namespace
}  // namespace tuftwave
