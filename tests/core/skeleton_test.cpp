#include "tuftwave/skeleton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "samples.hpp"
#include "support.hpp"
#include "tuftwave/tuft.hpp"

namespace tuftwave {
namespace {

using test::are_near;
using test::is_refused;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<Quat> globals(const Chain& chain) {
    std::vector<Quat> result;
    Quat parent = chain.parent_rotation;
    for (const Quat& local : chain.rest_rotations) result.push_back(parent = parent * local);
    return result;
}

TEST(ChainAlong, HasOneNodeMoreThanBones) {
    const Curve curve(test::fringe().points);
    for (const int joints : {1, 2, 6, 64}) {
        const Chain chain = chain_along(curve, joints);
        EXPECT_EQ(chain.nodes.size(), static_cast<std::size_t>(joints) + 1);
        EXPECT_EQ(chain.rest_rotations.size(), chain.nodes.size());
        EXPECT_EQ(chain.nodes.front(), test::fringe().points.front());
        EXPECT_TRUE(are_near(chain.nodes.back(), test::fringe().points.back(), 1e-12));
        EXPECT_FALSE(check_chain(chain, {}));
    }
}

TEST(ChainAlong, NodesLieAtEqualArcLengths) {
    for (const Tuft& tuft : test::all_tufts()) {
        const Curve curve(tuft.points);
        const Chain chain = chain_along(curve, 7);
        for (std::size_t i = 0; i <= 7; ++i) {
            EXPECT_TRUE(
                are_near(chain.nodes[i], curve.at(curve.arc_length() * static_cast<double>(i) / 7).point, 1e-12))
                << tuft.name << " " << i;
        }
    }
}

TEST(ChainAlong, EachBonesYRunsAlongItAndItsZAlongTheNormal) {
    for (const Tuft& tuft : test::all_tufts()) {
        Curve curve(tuft.points);
        curve.face_away_from({});
        const Chain chain = chain_along(curve, 5);
        const std::vector<Quat> rest = globals(chain);
        for (std::size_t i = 0; i < 5; ++i) {
            const Vec3 bone = chain.nodes[i + 1] - chain.nodes[i];
            if (length(bone) < 1e-9) continue;
            EXPECT_TRUE(are_near(rotated(rest[i], {0, 1, 0}), normalized(bone), 1e-12)) << tuft.name << " " << i;
            const CurveFrame middle = curve.at(curve.arc_length() * (static_cast<double>(i) + 0.5) / 5);
            EXPECT_GE(dot(rotated(rest[i], {0, 0, 1}), middle.normal), -1e-12) << tuft.name << " " << i;
        }
    }
}

TEST(ChainAlong, TheTipTurnsNothing) {
    EXPECT_EQ(chain_along(Curve(test::ponytail().points), 4).rest_rotations.back(), Quat{});
}

TEST(ChainAlong, ABoneThatEndsWhereItBeganStillHasADirection) {
    // Out and back in one bone: the chord is nothing, the tangent in its middle is not.
    const Chain chain = chain_along(Curve(test::there_and_back().points), 1);
    const Quat& rest = chain.rest_rotations.front();
    EXPECT_NEAR(dot(rest, rest), 1, 1e-12);
}

TEST(Influence, OfOneBoneIsAll) {
    for (const double along : {0.0, 0.3, 1.0}) {
        const Influence influence = influence_at(along, 1);
        EXPECT_EQ(influence.first, 0);
        EXPECT_EQ(influence.second, 0);
        EXPECT_EQ(influence.second_weight, 0);
    }
}

TEST(Influence, IsWholeInTheMiddleOfABoneAndHalvedBetweenTwo) {
    for (int bone = 0; bone < 6; ++bone) {
        const Influence middle = influence_at((bone + 0.5) / 6, 6);
        const double own = middle.first == bone ? 1 - middle.second_weight : middle.second_weight;
        EXPECT_NEAR(own, 1, 1e-12) << bone;
    }
    const Influence between = influence_at(3.0 / 6, 6);
    EXPECT_EQ(between.first, 2);
    EXPECT_EQ(between.second, 3);
    EXPECT_NEAR(between.second_weight, 0.5, 1e-12);
}

TEST(Influence, ChangesSmoothlyAndStaysInRange) {
    constexpr int kSteps = 10'000;
    for (const int joints : {1, 2, 6, 64}) {
        std::vector<double> before(static_cast<std::size_t>(joints), 0.0);
        before[0] = 1;
        for (int i = 0; i <= kSteps; ++i) {
            const Influence influence = influence_at(static_cast<double>(i) / kSteps, joints);
            ASSERT_LE(influence.first, influence.second);
            ASSERT_LT(influence.second, joints);
            ASSERT_TRUE(influence.second_weight >= 0 && influence.second_weight <= 1);
            std::vector<double> here(before.size(), 0.0);
            here[influence.first] += 1 - influence.second_weight;
            here[influence.second] += influence.second_weight;
            // 1.5 is the steepest slope of a smooth step, per bone.
            for (std::size_t k = 0; k < here.size(); ++k) ASSERT_NEAR(here[k], before[k], 1.6 * joints / kSteps) << i;
            before = here;
        }
        EXPECT_EQ(before.back(), 1);
    }
}

TEST(Influence, BeyondTheEndsIsThatOfTheEnds) {
    EXPECT_EQ(influence_at(-1, 6).first, 0);
    EXPECT_EQ(influence_at(2, 6).first, 5);
    EXPECT_EQ(influence_at(2, 6).second_weight, 0);
}

TEST(CheckChain, RefusesWithCodeAndField) {
    const struct {
        const char* name;
        std::function<void(Chain&)> change;
        ErrorCode code;
        const char* field;
    } cases[] = {
        {"one node", [](Chain& c) { c.nodes.resize(1); }, ErrorCode::kTooFew, "/nodes"},
        {"too many nodes", [](Chain& c) { c.nodes.resize(66); }, ErrorCode::kTooMany, "/nodes"},
        {"node not a number", [](Chain& c) { c.nodes[1].z = kNaN; }, ErrorCode::kNotFinite, "/nodes/1/2"},
        {"node far away", [](Chain& c) { c.nodes[2].x = 1e7; }, ErrorCode::kOutOfRange, "/nodes/2/0"},
        {"no length",
         [](Chain& c) {
             c.nodes.assign(3, {1, 2, 3});
         },
         ErrorCode::kDegenerate, "/nodes"},
        {"a rotation missing", [](Chain& c) { c.rest_rotations.pop_back(); }, ErrorCode::kConflict, "/rest_rotations"},
        {"rotation of nothing",
         [](Chain& c) {
             c.rest_rotations[1] = {0, 0, 0, 0};
         },
         ErrorCode::kDegenerate, "/rest_rotations/1"},
        {"rotation not a number", [](Chain& c) { c.rest_rotations[0].w = kNaN; }, ErrorCode::kNotFinite,
         "/rest_rotations/0/3"},
        {"parent of nothing",
         [](Chain& c) {
             c.parent_rotation = {0, 0, 0, 0};
         },
         ErrorCode::kDegenerate, "/parent_rotation"},
        {"outward of nothing", [](Chain& c) { c.outward = Vec3{}; }, ErrorCode::kDegenerate, "/outward"},
        {"phase not a number", [](Chain& c) { c.phase = kNaN; }, ErrorCode::kNotFinite, "/phase"},
        {"phase too large", [](Chain& c) { c.phase = 1001; }, ErrorCode::kOutOfRange, "/phase"},
        {"no cycles", [](Chain& c) { c.cycles = 0; }, ErrorCode::kOutOfRange, "/cycles"},
    };
    for (const auto& wrong : cases) {
        Chain chain;
        chain.nodes = {{0, 0, 0}, {0, -0.1, 0}, {0, -0.2, 0}};
        chain.rest_rotations.resize(3);
        ASSERT_FALSE(check_chain(chain, {}));
        wrong.change(chain);
        EXPECT_TRUE(is_refused(check_chain(chain, {}), wrong.code, wrong.field)) << wrong.name;
    }
}

TEST(Influence, ABoneWithoutWeightIsNotNamed) {
    Tuft tuft = test::tuft_along("line", {{0, 0.1, 0}, {0, 0.3, 0}});
    tuft.joints = 13;  // with 25 rings one second weight rounds to 1
    MeshDetail detail;
    detail.rings = 25;
    const Mesh mesh = to_mesh(plan_tuft(tuft, Head{}, detail, Limits{})->mesh);
    for (std::size_t i = 0; i < mesh.weights.size(); ++i) {
        EXPECT_TRUE(mesh.weights[i] > 0 || mesh.joints[i] == 0) << i;
    }
}

}  // namespace
}  // namespace tuftwave
