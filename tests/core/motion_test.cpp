#include "tuftwave/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "moving_chains.hpp"
#include "support.hpp"

namespace tuftwave {
namespace {

using test::all_motions;
using test::are_near;
using test::chain_of;
using test::hanging;
using test::is_refused;
using test::kPictures;
using test::motion_in;
using test::moved;
using test::pictures;
using test::Random;
using test::schedule_of;
using test::straight;
using test::with_outward;
using test::with_rest_rotations;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(Motion, BonesKeepTheirLength) {
    for (const Motion& motion : all_motions()) {
        const Chain chain = with_outward(hanging());
        for (const auto& nodes : pictures(chain, motion)) {
            EXPECT_EQ(nodes[0], chain.nodes[0]);
            for (std::size_t i = 1; i < nodes.size(); ++i) {
                EXPECT_NEAR(length(nodes[i] - nodes[i - 1]), length(chain.nodes[i] - chain.nodes[i - 1]), 1e-15) << i;
            }
        }
    }
}

// The paper's own setting, worked out in the plane of wind and up.
TEST(Motion, AbsoluteWithoutMoreIsThePapersLine) {
    Motion motion = motion_in(Mode::kAbsolute);
    motion.wind = {0, 0, 2};
    motion.up = {0, 1, 0.5};
    const Chain chain = hanging();
    const auto all = pictures(chain, motion);
    std::vector<double> x{0};
    for (std::size_t i = 1; i < chain.nodes.size(); ++i)
        x.push_back(x.back() + length(chain.nodes[i] - chain.nodes[i - 1]));
    for (std::size_t n = 0; n < kPictures; ++n) {
        const auto height = [&](const double at) {
            return wave_height(motion.wave, wave_envelope(motion.wave, at), at,
                               2 * kPi * static_cast<double>(n) / kPictures);
        };
        std::vector<Vec3> wanted{chain.nodes[0]};
        for (std::size_t i = 1; i < x.size(); ++i) {
            const double from = kPi * x[i - 1] / x.back(), to = kPi * x[i] / x.back();
            const double angle = std::atan2(height(to) - height(from), to - from);
            wanted.push_back(wanted.back() + (x[i] - x[i - 1]) * Vec3{0, std::sin(angle), std::cos(angle)});
        }
        EXPECT_TRUE(are_near(all[n], wanted, 1e-12)) << "picture " << n;
    }
}

TEST(Motion, WithoutAmplitudeIsTheRestPose) {
    Motion motion;
    motion.wave.amplitude = 0;
    Random random(4);
    const Chain chain = with_rest_rotations(hanging(), [&] { return random.rotation(); });
    const ChainMotion still = moved(chain, motion);
    for (std::size_t at = 0; at < still.rotations.size(); ++at) {
        EXPECT_NEAR(std::abs(dot(still.rotations[at], chain.rest_rotations[at % chain.nodes.size()])), 1, 1e-14) << at;
    }
    for (const auto& nodes : pictures(chain, motion)) EXPECT_TRUE(are_near(nodes, chain.nodes, 1e-14));
}

TEST(Motion, WithTheDroopRemovedSwingsEvenlyAboutTheRestPose) {
    const Chain chain = straight({0, -1, 0}, 3);
    std::vector<double> sum(3, 0.0);
    for (const auto& nodes : pictures(chain, {})) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 bone = nodes[i + 1] - nodes[i];
            sum[i] += std::atan2(bone.x, -bone.y);
        }
    }
    for (const double mean : sum) EXPECT_NEAR(mean, 0, 1e-12);
}

TEST(Motion, BothModesAgreeOnAStraightChainAlongTheWind) {
    Random random(8);
    for (int i = 0; i < 50; ++i) {
        Motion relative = motion_in(Mode::kRelative, Droop::kKeep), absolute = motion_in(Mode::kAbsolute, Droop::kKeep);
        relative.wind = absolute.wind = random.direction();
        relative.up = absolute.up = random.direction();
        const Chain chain = straight(relative.wind, 1 + random.below(8));
        const auto a = pictures(chain, relative), b = pictures(chain, absolute);
        for (std::size_t n = 0; n < kPictures; ++n)
            EXPECT_TRUE(are_near(a[n], b[n], 1e-12)) << "seed 8, case " << i << ", picture " << n;
    }
}

TEST(Motion, OfOneSegmentSwings) {
    const Chain chain = straight({0, -1, 0}, 1);
    for (const Motion& motion : all_motions()) {
        const auto all = pictures(with_outward(chain), motion);
        EXPECT_GT(length(all[0][1] - all[3][1]), 0.01);
    }
}

// VRoid's bones are turned by about 180 degrees about Z. Turning each bone in its own frame instead of the model's
// would send these the other way.
TEST(Motion, DoesNotDependOnRestRotations) {
    Random random(9);
    const std::function<Quat()> kinds[] = {[] {
                                               return Quat{0, 0, 1, 0};
                                           },
                                           [&] { return random.rotation(); },
                                           [&] {
                                               const Quat q = random.rotation();
                                               return Quat{3 * q.x, 3 * q.y, 3 * q.z, 3 * q.w};
                                           }};
    for (const Motion& motion : all_motions()) {
        const Chain plain = with_outward(hanging());
        const auto wanted = pictures(plain, motion);
        for (const auto& kind : kinds) {
            const auto all = pictures(with_rest_rotations(plain, kind), motion);
            for (std::size_t n = 0; n < kPictures; ++n)
                EXPECT_TRUE(are_near(all[n], wanted[n], 1e-13)) << "picture " << n;
        }
    }
}

TEST(Motion, TheTipKeepsItsRestRotation) {
    Random random(10);
    const Chain chain = with_rest_rotations(hanging(), [&] { return random.rotation(); });
    const ChainMotion all = moved(chain, {});
    const std::size_t nodes = chain.nodes.size();
    for (std::size_t n = 0; n < kPictures; ++n) {
        EXPECT_NEAR(std::abs(dot(all.rotations[n * nodes + nodes - 1], chain.rest_rotations.back())), 1, 1e-14) << n;
    }
}

TEST(Motion, QuaternionsAreUnitAndDoNotFlipTheirSign) {
    Random random(12);
    for (int i = 0; i < 50; ++i) {
        const Chain chain = with_rest_rotations(hanging(), [&] { return random.rotation(); });
        const ChainMotion all = moved(chain, {});
        const std::size_t nodes = chain.nodes.size();
        for (std::size_t at = 0; at < all.rotations.size(); ++at) {
            ASSERT_NEAR(dot(all.rotations[at], all.rotations[at]), 1, 1e-14) << at;
            const double agreement =
                at < nodes ? all.rotations[at].w : dot(all.rotations[at], all.rotations[at - nodes]);
            ASSERT_GE(agreement, 0) << "seed 12, chain " << i << ", rotation " << at;
        }
    }
}

/// Of 400 random chains that lie on a head of 10 cm radius, how many have a node inside it in some picture.
int chains_that_enter(const bool one_sided) {
    constexpr double kRadius = 0.1, kRounding = 1e-9;
    Random random(7);
    int entered = 0;
    for (int i = 0; i < 400; ++i) {
        Vec3 place = random.direction(), way = normalized(rejected(random.direction(), place));
        std::vector<Vec3> nodes{kRadius * place};
        const Vec3 outward = place;
        const double step = random.between(0.05, 0.2);
        for (int bones = 1 + random.below(8); bones > 0; --bones) {
            way = normalized(rejected(way + 0.3 * random.direction(), place));
            place = normalized(place + step * way);
            nodes.push_back(kRadius * place);
        }
        Chain chain = chain_of(nodes);
        chain.outward = outward;
        Motion motion;
        motion.one_sided = one_sided;
        motion.wind = random.direction();
        motion.up = random.direction();
        bool enters = false;
        for (const auto& picture : pictures(chain, motion)) {
            for (const Vec3& node : picture) enters = enters || length(node) < kRadius - kRounding;
        }
        entered += enters ? 1 : 0;
    }
    return entered;
}

TEST(Motion, OneSidedHairNeverEntersTheHeadItLiesOn) { EXPECT_EQ(chains_that_enter(true), 0) << "seed 7"; }

TEST(Motion, HairThatSwingsBothWaysDoesEnterIt) { EXPECT_GT(chains_that_enter(false), 100) << "seed 7"; }

TEST(Motion, LiftRaisesTheChainFromRestToTheWind) {
    for (const Mode mode : {Mode::kRelative, Mode::kAbsolute}) {
        Motion motion = motion_in(mode);
        motion.wave.amplitude = 0;
        const Chain chain = straight({0, -1, 0}, 4);
        const std::pair<double, Vec3> cases[] = {{0, {0, -1, 0}}, {0.5, normalized(Vec3{1, -1, 0})}, {1, {1, 0, 0}}};
        for (const auto& [lift, direction] : cases) {
            motion.lift = lift;
            const auto nodes = pictures(chain, motion)[0];
            EXPECT_TRUE(are_near(nodes.back(), chain.nodes[0] + 0.3 * direction, 1e-12)) << lift;
        }
    }
}

TEST(Motion, WindAgainstTheHairIsNoSpecialCase) {
    for (Motion motion : all_motions()) {
        motion.wind = {0, 0, -1};
        Chain chain = straight({0, 0, 1}, 4);
        chain.outward = {0, 1, 0};
        for (const auto& nodes : pictures(chain, motion)) {
            for (const Vec3& node : nodes) EXPECT_TRUE(is_finite(node));
            EXPECT_NEAR(nodes.back().x, 0.1, 1e-12) << "it swings in the plane of wind and up";
        }
    }
}

TEST(Motion, AChainThatEndsAtItsRootStillMoves) {
    for (const Motion& motion : all_motions()) {
        const Chain loop = with_outward(chain_of({{0, 0.1, 0}, {0.05, 0.1, 0}, {0.05, 0.05, 0}, {0, 0.1, 0}}));
        const auto all = pictures(loop, motion);
        for (const auto& nodes : all) {
            for (const Vec3& node : nodes) EXPECT_TRUE(is_finite(node));
        }
        EXPECT_GT(length(all[0][1] - all[3][1]), 1e-3);
    }
}

TEST(Motion, NodesAtTheSamePlaceAreNoSpecialCase) {
    for (const Motion& motion : all_motions()) {
        const Chain chain = with_outward(chain_of({{0, 0.1, 0}, {0, 0.1, 0}, {0, 0, 0}, {0, 0, 0}}));
        for (const auto& nodes : pictures(chain, motion)) {
            for (const Vec3& node : nodes) EXPECT_TRUE(is_finite(node));
        }
    }
}

TEST(Motion, StopsWhenAsked) {
    std::stop_source source;
    source.request_stop();
    const std::vector<Chain> chains{hanging()};
    EXPECT_TRUE(is_refused(move_chains(chains, {}, schedule_of(), {}, InOrder{}, source.get_token()),
                           ErrorCode::kCancelled, ""));
}

TEST(CheckMotion, RefusesWithCodeAndField) {
    const struct {
        const char* name;
        std::function<void(Motion&)> change;
        ErrorCode code;
        const char* field;
    } cases[] = {
        {"no lightness", [](Motion& m) { m.wave.lightness = 0; }, ErrorCode::kOutOfRange, "/wave/lightness"},
        {"no wind", [](Motion& m) { m.wind = {}; }, ErrorCode::kDegenerate, "/wind"},
        {"wind not a number", [](Motion& m) { m.wind.z = kNaN; }, ErrorCode::kNotFinite, "/wind/2"},
        {"no up", [](Motion& m) { m.up = {}; }, ErrorCode::kDegenerate, "/up"},
        {"wind along up",
         [](Motion& m) {
             m.wind = {0, 3, 0};
         },
         ErrorCode::kDegenerate, "/wind"},
        {"wind against up",
         [](Motion& m) {
             m.wind = {0, -3, 0};
         },
         ErrorCode::kDegenerate, "/wind"},
        {"lift too high", [](Motion& m) { m.lift = 1.1; }, ErrorCode::kOutOfRange, "/lift"},
        {"lift not a number", [](Motion& m) { m.lift = kNaN; }, ErrorCode::kNotFinite, "/lift"},
        {"one-sided in absolute mode", [](Motion& m) { m.one_sided = true, m.mode = Mode::kAbsolute; },
         ErrorCode::kConflict, "/one_sided"},
        {"no gust wavelength", [](Motion& m) { m.phase.gust_wavelength = 0; }, ErrorCode::kOutOfRange,
         "/phase/gust_wavelength"},
        {"spread too wide", [](Motion& m) { m.phase.spread = 1.5; }, ErrorCode::kOutOfRange, "/phase/spread"},
        {"no cycles", [](Motion& m) { m.phase.cycles = 0; }, ErrorCode::kOutOfRange, "/phase/cycles"},
        {"half as many cycles as pictures", [](Motion& m) { m.phase.cycles = 3; }, ErrorCode::kConflict,
         "/phase/cycles"},
    };
    for (const auto& wrong : cases) {
        Motion motion;
        ASSERT_FALSE(check_motion(motion, schedule_of(), {}));
        wrong.change(motion);
        EXPECT_TRUE(is_refused(check_motion(motion, schedule_of(), {}), wrong.code, wrong.field)) << wrong.name;
        const std::vector<Chain> chains{with_outward(hanging())};
        EXPECT_TRUE(is_refused(move_chains(chains, motion, schedule_of(), {}, InOrder{}, {}), wrong.code,
                               std::string("/motion") + wrong.field))
            << wrong.name;
    }
}

TEST(MoveChains, RefusesWithTheChainNamed) {
    std::vector<Chain> chains{with_outward(hanging()), hanging()};
    Motion motion;
    motion.one_sided = true;
    const auto move = [&](const Limits& limits) {
        return move_chains(chains, motion, schedule_of(), limits, InOrder{}, {});
    };
    EXPECT_TRUE(is_refused(move({}), ErrorCode::kDegenerate, "/chains/1/outward"));
    motion.one_sided = false;
    chains[1].cycles = 3;
    EXPECT_TRUE(is_refused(move({}), ErrorCode::kConflict, "/chains/1/cycles"));
    chains[1].cycles = {};
    Limits limits;
    limits.node_poses = 59;  // two chains of five nodes in six pictures are 60
    EXPECT_TRUE(is_refused(move(limits), ErrorCode::kTooMany, "/chains"));
    limits.node_poses = 60;
    EXPECT_TRUE(move(limits));
}

TEST(MoveChains, GivesTheSameBitsWithAllVectors) {
    for (const Motion& motion : all_motions()) {
        for (const int bones : {1, 4, 7, 8, 9, 64}) {  // around whole vectors, and as many as there may be
            const std::vector<Chain> chains{with_outward(straight({0.6, -0.8, 0}, bones)), with_outward(hanging())};
            const auto move = [&](Vectors vectors) {
                return *move_chains(chains, motion, schedule_of(motion.timing), {}, InOrder{}, {}, vectors);
            };
            const std::vector<ChainMotion> narrow = move(Vectors::kNarrow);
            for (const Vectors vectors : usable_vectors()) {
                const std::vector<ChainMotion> moved = move(vectors);
                for (std::size_t c = 0; c < chains.size(); ++c)
                    EXPECT_EQ(narrow[c].rotations, moved[c].rotations) << bones;
            }
        }
    }
}

}  // namespace
}  // namespace tuftwave
