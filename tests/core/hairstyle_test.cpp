#include "tuftwave/hairstyle.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <stop_token>
#include <string>
#include <vector>

#include "samples.hpp"
#include "support.hpp"

namespace tuftwave {
namespace {

using test::is_refused;

Hairstyle moving_hair() {
    Hairstyle hairstyle;
    hairstyle.tufts = test::smooth_tufts();
    hairstyle.motion = Motion{};
    hairstyle.motion->phase.spread = 0.5;
    return hairstyle;
}

Result<HairPlan> planned(const Hairstyle& hairstyle, const Limits& limits = {}) {
    return plan_hairstyle(hairstyle, limits, InOrder{}, {});
}

TEST(Hairstyle, PlansEveryTuftAndMovesEveryChain) {
    const Hairstyle hairstyle = moving_hair();
    const Result<HairPlan> plan = planned(hairstyle);
    ASSERT_TRUE(plan) << plan.error().field;
    ASSERT_EQ(plan->tufts.size(), hairstyle.tufts.size());
    ASSERT_EQ(plan->chains.size(), hairstyle.tufts.size());
    ASSERT_EQ(plan->motion->chains.size(), hairstyle.tufts.size());
    EXPECT_EQ(plan->motion->schedule.pictures, 6);
    std::size_t vertices = 0, indices = 0, joints = 0;
    for (std::size_t i = 0; i < plan->tufts.size(); ++i) {
        EXPECT_EQ(plan->chains[i].name, hairstyle.tufts[i].name);
        EXPECT_EQ(plan->motion->chains[i].rotations.size(), 6 * plan->chains[i].nodes.size());
        vertices += plan->tufts[i].vertex_count();
        indices += plan->tufts[i].index_count();
        joints += static_cast<std::size_t>(hairstyle.tufts[i].joints);
    }
    EXPECT_EQ(plan->vertices, vertices);
    EXPECT_EQ(plan->indices, indices);
    EXPECT_EQ(plan->joints, joints);
}

TEST(Hairstyle, ATuftOfOneBoneThatEndsWhereItBeganIsFinite) {
    Hairstyle hairstyle = moving_hair();
    hairstyle.head.root_depth = 0;  // so that the stroke's own ends meet
    hairstyle.tufts = {Tuft{}};
    hairstyle.tufts[0].points = {{0.1, 0, 0}, {0.2, 0, 0}, {0.1, 0, 0}};
    hairstyle.tufts[0].joints = 1;
    const Result<HairPlan> plan = planned(hairstyle);
    ASSERT_TRUE(plan) << plan.error().field;
    for (const Quat& q : plan->motion->chains[0].rotations) EXPECT_NEAR(dot(q, q), 1, 1e-12);
}

TEST(Hairstyle, WithoutMotionStaysStill) {
    Hairstyle hairstyle = moving_hair();
    hairstyle.motion.reset();
    const Result<HairPlan> plan = planned(hairstyle);
    ASSERT_TRUE(plan);
    EXPECT_FALSE(plan->motion);
}

TEST(Hairstyle, KeepsNoMoreThanSizesWhereRingsAreGivenAndNothingHangsOnBones) {
    Hairstyle hairstyle = moving_hair();
    hairstyle.motion.reset();
    hairstyle.mesh.rings = 9;
    hairstyle.fills.push_back({0, 1, {}});
    const Result<HairPlan> skinned = planned(hairstyle);
    hairstyle.mesh.skin = false;
    const Result<HairPlan> plan = planned(hairstyle);
    ASSERT_TRUE(skinned && plan);
    ASSERT_GT(plan->tufts.size(), hairstyle.tufts.size());
    EXPECT_EQ(plan->vertices, skinned->vertices);
    EXPECT_EQ(plan->indices, skinned->indices);
    EXPECT_EQ(plan->joints, 0u);
    MeshPlan made;
    for (std::size_t i = 0; i < plan->tufts.size(); ++i) {
        EXPECT_TRUE(plan->tufts[i].rings.empty());
        EXPECT_EQ(plan->chains[i].name, skinned->chains[i].name);
        const Mesh mesh = to_mesh(mesh_plan(*plan, i, made));
        EXPECT_EQ(mesh.positions, to_mesh(mesh_plan(*skinned, i, made)).positions) << i;
    }
}

TEST(Hairstyle, MovesOnlyWhatHangsOnBones) {
    Hairstyle hairstyle = moving_hair();
    hairstyle.mesh.skin = false;
    EXPECT_TRUE(is_refused(planned(hairstyle), ErrorCode::kConflict, "/mesh/skin"));
}

TEST(Hairstyle, IsTheSameInWhateverOrderItIsPlanned) {
    Hairstyle hairstyle = moving_hair();
    for (Tuft& tuft : test::tight_tufts()) hairstyle.tufts.push_back(tuft);
    const Result<HairPlan> wanted = planned(hairstyle);
    const test::LastFirst last_first;
    const test::EvenFirst even_first;
    for (const ForEach* order : {static_cast<const ForEach*>(&last_first), static_cast<const ForEach*>(&even_first)}) {
        const Result<HairPlan> plan = plan_hairstyle(hairstyle, {}, *order, {});
        ASSERT_TRUE(plan);
        for (std::size_t i = 0; i < hairstyle.tufts.size(); ++i) {
            EXPECT_EQ(to_mesh(plan->tufts[i]).positions, to_mesh(wanted->tufts[i]).positions) << i;
            EXPECT_EQ(plan->chains[i].nodes, wanted->chains[i].nodes) << i;
            EXPECT_EQ(plan->motion->chains[i].rotations, wanted->motion->chains[i].rotations) << i;
        }
    }
}

TEST(Hairstyle, EachLimitFires) {
    const Result<HairPlan> plan = planned(moving_hair());
    const struct {
        const char* name;
        std::function<void(Limits&)> change;
        const char* field;
        const char* allowed;  // what the message speaks of
    } cases[] = {
        {"tufts", [](Limits& l) { l.tufts = 4; }, "/tufts", "1 to 4"},
        {"points", [](Limits& l) { l.points = 19; }, "/tufts", "points"},
        {"points of a tuft", [](Limits& l) { l.points_per_tuft = 4; }, "/tufts/1/points", "2 to 4"},
        {"joints", [](Limits& l) { l.joints = 26; }, "/tufts", "joints"},
        {"joints of a tuft",
         [](Limits& l) {
             l.joints_per_tuft = {1, 7};
         },
         "/tufts/1/joints", "1 to 7"},
        {"rings of a tuft", [](Limits& l) { l.rings_per_tuft = 5; }, "/tufts/0", "rings"},
        {"vertices", [&](Limits& l) { l.vertices = plan->vertices - 1; }, "/mesh", "vertices"},
        {"triangles", [&](Limits& l) { l.triangles = plan->indices / 3 - 1; }, "/mesh", "triangles"},
        {"node poses", [](Limits& l) { l.node_poses = 191; }, "/tufts",
         "191 nodes times pictures"},  // 27 bones and 5 tips, 6 pictures
        {"pictures", [](Limits& l) { l.pictures = 5; }, "/motion/timing/period", "pictures"},
        {"frames", [](Limits& l) { l.frames = 10; }, "/motion/timing/period", "frames"},
    };
    for (const auto& limit : cases) {
        Limits limits;
        limit.change(limits);
        const Result<HairPlan> refused = planned(moving_hair(), limits);
        const bool is_range = std::string(limit.name) == "joints of a tuft";
        ASSERT_TRUE(is_refused(refused, is_range ? ErrorCode::kOutOfRange : ErrorCode::kTooMany, limit.field))
            << limit.name;
        EXPECT_NE(refused.error().allowed.find(limit.allowed), std::string::npos)
            << limit.name << ": " << refused.error().allowed;
    }
}

TEST(Hairstyle, GivenRingsAreRefusedBeforeATuftIsPlanned) {
    Hairstyle hairstyle = moving_hair();
    hairstyle.tufts.resize(9, hairstyle.tufts[0]);
    hairstyle.tufts[0].diameter = 1e9;  // planning would trip over this first
    hairstyle.mesh.rings = 4'096;
    hairstyle.mesh.sides = 64;
    EXPECT_TRUE(is_refused(planned(hairstyle), ErrorCode::kTooMany, "/mesh"));
}

/// Counts the jobs it runs.
class Counting final : public ForEach {
  public:
    void operator()(const std::size_t count, const std::function<void(std::size_t)>& job) const override {
        jobs += count;
        for (std::size_t i = 0; i < count; ++i) job(i);
    }
    mutable std::size_t jobs = 0;
};

// A small body can ask for 16,384 tufts of 4,096 rings: they would take 6 GB before a vertex was counted.
TEST(Hairstyle, TooLargeAMeshIsNoticedBeforeAllOfItIsPlanned) {
    Hairstyle hairstyle;
    hairstyle.tufts.assign(16'384, test::ahoge());
    hairstyle.mesh.rings = 4'096;
    const Counting counting;
    EXPECT_TRUE(is_refused(plan_hairstyle(hairstyle, {}, counting, {}), ErrorCode::kTooMany, "/mesh"));
    EXPECT_LE(counting.jobs, 256U);
}

TEST(Hairstyle, JustAtItsLimitsIsAccepted) {
    const Result<HairPlan> plan = planned(moving_hair());
    Limits limits;
    limits.tufts = 5;
    limits.points = 20;
    limits.joints = 27;
    limits.vertices = plan->vertices;
    limits.triangles = plan->indices / 3;
    limits.node_poses = 192;
    limits.pictures = 6;
    limits.frames = 11;
    EXPECT_TRUE(planned(moving_hair(), limits));
}

TEST(Hairstyle, NamesTheFirstWrongTuftInWhateverOrderItIsPlanned) {
    Hairstyle hairstyle = moving_hair();
    hairstyle.tufts[3].diameter = 0;
    hairstyle.tufts[1].points[2].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(is_refused(planned(hairstyle), ErrorCode::kNotFinite, "/tufts/1/points/2/1"));
    EXPECT_TRUE(
        is_refused(plan_hairstyle(hairstyle, {}, test::LastFirst{}, {}), ErrorCode::kNotFinite, "/tufts/1/points/2/1"));
}

TEST(Hairstyle, RefusesWithCodeAndField) {
    const struct {
        const char* name;
        std::function<void(Hairstyle&)> change;
        ErrorCode code;
        const char* field;
    } cases[] = {
        {"no tufts", [](Hairstyle& h) { h.tufts.clear(); }, ErrorCode::kTooFew, "/tufts"},
        {"head without up", [](Hairstyle& h) { h.head.up = {}; }, ErrorCode::kDegenerate, "/head/up"},
        {"too many sides", [](Hairstyle& h) { h.mesh.sides = 65; }, ErrorCode::kOutOfRange, "/mesh/sides"},
        {"negative joints", [](Hairstyle& h) { h.tufts[2].joints = -5; }, ErrorCode::kOutOfRange, "/tufts/2/joints"},
        {"no hold", [](Hairstyle& h) { h.motion->timing.hold = 0; }, ErrorCode::kOutOfRange, "/motion/timing/hold"},
        {"no wind", [](Hairstyle& h) { h.motion->wind = {}; }, ErrorCode::kDegenerate, "/motion/wind"},
        {"no lightness", [](Hairstyle& h) { h.motion->wave.lightness = 0; }, ErrorCode::kOutOfRange,
         "/motion/wave/lightness"},
        {"too many cycles of a tuft", [](Hairstyle& h) { h.tufts[4].cycles = 3; }, ErrorCode::kConflict,
         "/tufts/4/cycles"},
        {"undefined as printed",  // 3 frames held by 4 are one picture, one frame short; 5 are two, three frames short
         [](Hairstyle& h) {
             h.formulas = Formulas::kAsPrinted, h.motion->timing = {5 / 24.0, {}, 4, {}, {}};
         },
         ErrorCode::kUndefinedAsPrinted, "/motion/timing/hold"},
    };
    for (const auto& wrong : cases) {
        Hairstyle hairstyle = moving_hair();
        wrong.change(hairstyle);
        EXPECT_TRUE(is_refused(planned(hairstyle), wrong.code, wrong.field)) << wrong.name;
    }
}

TEST(Hairstyle, StopsWhenAsked) {
    std::stop_source source;
    source.request_stop();
    EXPECT_TRUE(
        is_refused(plan_hairstyle(moving_hair(), {}, InOrder{}, source.get_token()), ErrorCode::kCancelled, ""));
}

/// Asks to stop before the third job.
class StopsHalfway final : public ForEach {
  public:
    explicit StopsHalfway(std::stop_source& source) : source_(source) {}
    void operator()(const std::size_t count, const std::function<void(std::size_t)>& job) const override {
        for (std::size_t i = 0; i < count; ++i) {
            if (i == 2) source_.request_stop();
            job(i);
        }
    }

  private:
    std::stop_source& source_;
};

TEST(Hairstyle, StoppedHalfwayHasNoResult) {
    std::stop_source source;
    EXPECT_TRUE(is_refused(plan_hairstyle(moving_hair(), {}, StopsHalfway(source), source.get_token()),
                           ErrorCode::kCancelled, ""));
}

/// Two fills: from the first twin tail over the back to the other one, and a ring of the fringe.
Hairstyle filled_hair() {
    Hairstyle hairstyle = moving_hair();
    hairstyle.fills.resize(2);
    hairstyle.fills[0].from = 2;
    hairstyle.fills[0].to = 3;
    hairstyle.fills[0].settings.density.crown = 50;
    hairstyle.fills[1].from = 0;
    hairstyle.fills[1].settings.name = "ring";
    return hairstyle;
}

TEST(HairstyleFills, ComeAfterTheDrawnTuftsAndMoveWithThem) {
    const Hairstyle hairstyle = filled_hair();
    const Result<HairPlan> plan = planned(hairstyle);
    ASSERT_TRUE(plan) << plan.error().field;
    ASSERT_EQ(plan->fills.size(), 2u);
    const std::size_t first = plan->fills[0].along + plan->fills[0].crown, second = plan->fills[1].along;
    EXPECT_GT(first, 3u);
    EXPECT_EQ(second, 16u);
    const std::size_t drawn = hairstyle.tufts.size();
    ASSERT_EQ(plan->chains.size(), drawn + first + second);
    EXPECT_EQ(plan->tufts.size(), plan->chains.size());
    EXPECT_EQ(plan->motion->chains.size(), plan->chains.size());
    EXPECT_EQ(plan->chains[drawn].name, "fill_1");
    EXPECT_EQ(plan->chains[drawn + first].name, "ring_1");
    EXPECT_EQ(plan->chains.back().name, "ring_16");
}

TEST(HairstyleFills, OfATuftWithItselfAreRings) {
    Hairstyle hairstyle = filled_hair();
    hairstyle.fills[1].to = 0;
    EXPECT_EQ(planned(hairstyle)->fills[1].along, 16u);
}

TEST(HairstyleFills, BetweenTuftsOfWhichOneIsWrongNameTheTuft) {
    Hairstyle hairstyle = filled_hair();
    hairstyle.tufts[3].points[1].x = 1e7;
    EXPECT_TRUE(is_refused(planned(hairstyle), ErrorCode::kOutOfRange, "/tufts/3/points/1/0"));
}

TEST(HairstyleFills, AreRefusedAtTheirPlace) {
    const struct {
        const char* name;
        std::function<void(Hairstyle&)> change;
        ErrorCode code;
        const char* field;
    } cases[] = {
        {"density", [](Hairstyle& h) { h.fills[1].settings.density.neck = 101; }, ErrorCode::kOutOfRange,
         "/fills/1/density/neck"},
        {"too dense", [](Hairstyle& h) { h.fills[0].settings.tufts_per_meter = 1e6; }, ErrorCode::kTooMany,
         "/fills/0/density/along"},
        {"head outside its scalp",
         [](Hairstyle& h) {
             h.head.scalp = ScalpEllipsoid{Vec3{0, 1, 0}, {0.1, 0.1, 0.1}};
         },
         ErrorCode::kDegenerate, "/head/scalp/ellipsoid"},
        {"too many", [](Hairstyle& h) { h.fills.resize(1025); }, ErrorCode::kTooMany, "/fills"},
    };
    for (const auto& wrong : cases) {
        Hairstyle hairstyle = filled_hair();
        wrong.change(hairstyle);
        EXPECT_TRUE(is_refused(planned(hairstyle), wrong.code, wrong.field)) << wrong.name;
    }
}

TEST(HairstyleFills, WithATuftThatCannotMoveNameTheDrawnOne) {
    Hairstyle hairstyle = filled_hair();
    hairstyle.tufts[3].cycles = 5;  // of six pictures
    EXPECT_TRUE(is_refused(planned(hairstyle), ErrorCode::kConflict, "/tufts/3/cycles"));
}

TEST(HairstyleFills, CountWithTheDrawnTuftsAndSayHowManyWouldHaveCome) {
    const Hairstyle hairstyle = filled_hair();
    const std::size_t all = planned(hairstyle)->chains.size();
    Limits limits;
    limits.tufts = all;
    EXPECT_TRUE(planned(hairstyle, limits));
    limits.tufts = all - 1;
    const Result<HairPlan> refused = planned(hairstyle, limits);
    ASSERT_TRUE(is_refused(refused, ErrorCode::kTooMany, "/fills/1"));
    EXPECT_EQ(std::get<double>(refused.error().given), static_cast<double>(all));
    limits = {};
    limits.joints = 60;
    EXPECT_TRUE(is_refused(planned(hairstyle, limits), ErrorCode::kTooMany, "/tufts"));
}

TEST(HairstyleFills, StopWhenTheyAreTold) {
    std::stop_source source;
    source.request_stop();
    EXPECT_TRUE(
        is_refused(plan_hairstyle(filled_hair(), {}, InOrder{}, source.get_token()), ErrorCode::kCancelled, ""));
}

}  // namespace
}  // namespace tuftwave
