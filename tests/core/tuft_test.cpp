#include "tuftwave/tuft.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mesh_invariants.hpp"
#include "ring_invariants.hpp"
#include "samples.hpp"
#include "support.hpp"
#include "tuftwave/curve.hpp"
#include "welded_mesh.hpp"

namespace tuftwave {
namespace {

using test::are_near;
using test::is_refused;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr Taper kTapers[] = {Taper::kSine, Taper::kLinear, Taper::kSmooth, Taper::kRound};

MeshPlan planned(const Tuft& tuft, const MeshDetail& detail = {}, const Head& head = {}) {
    Result<PlannedTuft> plan = plan_tuft(tuft, head, detail, {});
    EXPECT_TRUE(plan) << tuft.name << ": " << (plan ? "" : plan.error().field + ", allowed " + plan.error().allowed);
    return plan ? std::move(plan).value().mesh : MeshPlan{};
}

/// What holds for every tuft, however it bends.
void expect_sound(const Tuft& tuft, const MeshDetail& detail = {}) {
    const MeshPlan plan = planned(tuft, detail);
    const Mesh mesh = to_mesh(plan);
    EXPECT_TRUE(test::is_finite_mesh(mesh)) << tuft.name;
    EXPECT_TRUE(test::is_closed(test::welded(mesh))) << tuft.name;
    EXPECT_TRUE(test::has_unit_normals(mesh)) << tuft.name;
    EXPECT_TRUE(test::has_sound_weights(mesh, tuft.joints)) << tuft.name;
    EXPECT_GT(test::volume(mesh), 0) << tuft.name;
    EXPECT_TRUE(test::runs_forwards(plan, mesh)) << tuft.name;
    EXPECT_TRUE(test::has_no_spikes(plan, mesh)) << tuft.name;
}

/// 25 cm straight along +X above the head, so that outward is +Y; no stub below the scalp.
Tuft straight() { return test::tuft_along("straight", {{0, 0.1, 0}, {0.25, 0.1, 0}}); }
Head bald() {
    Head head;
    head.root_depth = 0;
    return head;
}

/// The size of a ring along an axis, root to tip of a `straight` tuft; sides divisible by 4 put corners on the axes.
double extent(const MeshPlan& plan, const std::size_t ring, const double Vec3::*axis) {
    const Mesh mesh = to_mesh(plan);
    double low = 1e9, high = -1e9;
    for (std::size_t j = 0; j < static_cast<std::size_t>(plan.sides); ++j) {
        low = std::min(low, test::ring_vertex(plan, mesh, ring, j).*axis);
        high = std::max(high, test::ring_vertex(plan, mesh, ring, j).*axis);
    }
    return high - low;
}

std::size_t widest_ring(const MeshPlan& plan) {
    const auto widths = plan.rings.half_widths();
    return static_cast<std::size_t>(std::ranges::max_element(widths) - widths.begin());
}

TEST(Tuft, EverySampleIsClosedOutwardAndFree) {
    for (const Tuft& tuft : test::all_tufts()) expect_sound(tuft);
}

TEST(Tuft, EverySampleIsASphereWithoutHandles) {
    for (const Tuft& tuft : test::all_tufts()) {
        EXPECT_TRUE(test::is_sphere(test::welded(to_mesh(planned(tuft))))) << tuft.name;
    }
}

TEST(Tuft, NormalsAgreeWithFaces) {
    for (const Tuft& tuft : test::smooth_tufts())
        EXPECT_TRUE(test::has_outward_normals(to_mesh(planned(tuft)))) << tuft.name;
}

TEST(Tuft, OfARandomStrokeRunsForwardsWithoutSpikes) {
    test::Random random(5);
    for (int i = 0; i < 500; ++i) {
        Tuft tuft = test::tuft_along("seed 5, stroke " + std::to_string(i), {0.1 * random.direction()});
        const double bend = random.between(0, 1.5);
        Vec3 direction = random.direction();
        for (int k = random.below(8) + 1; k > 0; --k) {
            direction = normalized(direction + bend * random.direction());
            tuft.points.push_back(tuft.points.back() + random.between(0.01, 0.05) * direction);
        }
        tuft.diameter = random.between(1, 100);
        tuft.widest_at = i % 5 == 0 ? 100 : random.between(1, 100);
        tuft.taper = kTapers[random.below(4)];
        tuft.section = Section::kEllipse;
        tuft.flatness = random.between(0, 0.98);
        tuft.twist_deg = i % 3 == 0 ? random.between(-720, 720) : 0;
        tuft.joints = 1 + random.below(12);
        expect_sound(tuft);
    }
}

TEST(Tuft, TighterThanItsOwnRadiusKeepsItsColumnsInOrder) {
    for (const double radius : {0.02, 0.01, 0.005, 0.002}) {
        Tuft ringlet = test::ringlet(radius);
        ringlet.diameter = 60;
        EXPECT_FALSE(planned(ringlet).reach.shares.empty()) << radius;
        expect_sound(ringlet);
    }
    for (const double diameter : {5.0, 20.0, 60.0, 100.0}) {
        for (Tuft tuft : test::tight_tufts()) {
            tuft.diameter = diameter;
            expect_sound(tuft);
        }
    }
}

TEST(Tuft, WiderThanItsBendIsNotCutBack) {
    Tuft ringlet = test::ringlet(0.05);
    ringlet.diameter = 10;
    EXPECT_TRUE(planned(ringlet, {}, bald()).reach.shares.empty());
}

TEST(Tuft, HasNoHolesOrNotANumberAtItsTips) {
    for (const Taper taper : kTapers) {
        for (const double widest : {1.0, 50.0, 99.0, 99.99999, 100.0}) {
            for (Tuft tuft : {test::fringe(), test::ahoge(), straight()}) {
                tuft.taper = taper;
                tuft.widest_at = widest;
                expect_sound(tuft);
                expect_sound(tuft, {.tolerance = 3e-4, .rings = 2, .sides = 3});
            }
        }
    }
}

TEST(Tuft, ClosesEachEndInOneApex) {
    const MeshPlan plan = planned(test::ponytail());
    const Mesh mesh = to_mesh(plan);
    const std::size_t tip = plan.vertex_count() - 1;
    EXPECT_TRUE(are_near(test::triple(mesh.positions, 0), sunk_root({}, test::ponytail().points.front()), 1e-7));
    EXPECT_TRUE(are_near(test::triple(mesh.positions, tip), test::ponytail().points.back(), 1e-7));
    EXPECT_EQ(std::count(mesh.indices.begin(), mesh.indices.end(), 0U), plan.sides);
    EXPECT_EQ(std::count(mesh.indices.begin(), mesh.indices.end(), static_cast<std::uint32_t>(tip)), plan.sides);
}

TEST(Tuft, WidestAtTheEndHasAFlatCap) {
    Tuft tuft = straight();
    tuft.widest_at = 100;
    const MeshPlan plan = planned(tuft);
    const Mesh mesh = to_mesh(plan);
    ASSERT_TRUE(plan.flat_tip);
    EXPECT_EQ(plan.rings.along().back(), 1);
    for (std::size_t vertex = plan.vertex_count() - 14; vertex < plan.vertex_count(); ++vertex) {  // 13 around, 1 apex
        EXPECT_TRUE(are_near(test::triple(mesh.normals, vertex), {1, 0, 0}, 1e-6)) << vertex;
        EXPECT_NEAR(mesh.positions[3 * vertex], 0.25, 1e-7) << vertex;
        EXPECT_EQ(mesh.uvs[2 * vertex + 1], 1) << vertex;
    }
    EXPECT_NEAR(extent(plan, plan.rings.size() - 1, &Vec3::y), 0.04, 1e-7);
}

TEST(Tuft, CoordinatesOfTexturesRunAroundAndAlong) {
    const MeshPlan plan = planned(test::fringe());
    const Mesh mesh = to_mesh(plan);
    EXPECT_EQ(mesh.uvs[1], 0);
    EXPECT_EQ(mesh.uvs.back(), 1);
    float before = 0;
    for (std::size_t ring = 0; ring < plan.rings.size(); ++ring) {
        for (std::size_t column = 0; column <= 12; ++column) {
            const std::size_t vertex = 1 + 13 * ring + column;
            EXPECT_FLOAT_EQ(mesh.uvs[2 * vertex], static_cast<float>(column) / 12) << vertex;
            EXPECT_EQ(mesh.uvs[2 * vertex + 1], static_cast<float>(plan.rings[ring].along)) << vertex;
        }
        EXPECT_GT(static_cast<float>(plan.rings[ring].along), before) << ring;
        before = static_cast<float>(plan.rings[ring].along);
    }
}

TEST(Tuft, FirstAndLastColumnAreTheSamePlaces) {
    const MeshPlan plan = planned(test::twin_tail(1));
    const Mesh mesh = to_mesh(plan);
    for (std::size_t ring = 0; ring < plan.rings.size(); ++ring) {
        EXPECT_EQ(test::ring_vertex(plan, mesh, ring, 0), test::ring_vertex(plan, mesh, ring, 12)) << ring;
    }
}

/// The largest distance between the curve of a tuft, or its width, and the straight pieces of its mesh.
double worst_error(const Tuft& tuft, const MeshPlan& plan, const Head& head) {
    std::vector<Vec3> points{sunk_root(head, tuft.points.front())};
    points.insert(points.end(), tuft.points.begin(), tuft.points.end());
    const Curve curve(points);
    std::vector<Ring> rings{Ring{{plan.root, {}, {}}, 0, 0, 0}};
    for (std::size_t i = 0; i < plan.rings.size(); ++i) rings.push_back(plan.rings[i]);
    if (!plan.flat_tip) rings.push_back(Ring{{plan.tip, {}, {}}, 1, 0, 0});
    double worst = 0;
    for (std::size_t i = 1; i < rings.size(); ++i) {
        const Ring &a = rings[i - 1], &b = rings[i];
        for (int k = 1; k < 20; ++k) {
            const double part = k / 20.0, along = (1 - part) * a.along + part * b.along;
            const Vec3 chord = b.frame.point - a.frame.point,
                       from = curve.at(along * curve.arc_length()).point - a.frame.point;
            const double share = std::clamp(dot(from, chord) / dot(chord, chord), 0.0, 1.0);
            const double width =
                head.diameter_at_100 * tuft.diameter / 200 * profile_width(tuft.taper, along, tuft.widest_at / 100);
            worst = std::max({worst, length(from - share * chord),
                              std::abs((1 - part) * a.half_width + part * b.half_width - width)});
        }
    }
    return worst;
}

// Gentle S curves and the smooth taper cross their chords in the middle, which is the smallest case where looking at
// the middle alone is not enough.
TEST(Tuft, ToleranceIsMetAllAlong) {
    Tuft wavy = test::tuft_along(
        "wavy", {{0, 0.1, 0}, {0.0625, 0.103, 0}, {0.125, 0.1, 0}, {0.1875, 0.097, 0}, {0.25, 0.1, 0}});
    std::vector<Tuft> tufts = test::all_tufts();
    for (const Taper taper : kTapers) {
        wavy.joints = 1;
        wavy.taper = taper;
        tufts.push_back(wavy);
        wavy.widest_at = 100;
        tufts.push_back(wavy);
    }
    for (const Tuft& tuft : tufts) {
        for (const double tolerance : {2e-3, 3e-4, 5e-5}) {
            const MeshPlan plan = planned(tuft, {.tolerance = tolerance, .rings = {}, .sides = 12}, bald());
            EXPECT_LE(worst_error(tuft, plan, bald()), tolerance) << tuft.name;
        }
    }
}

TEST(Tuft, FinerToleranceNeverGivesFewerRings) {
    for (const Tuft& tuft : test::all_tufts()) {
        std::size_t before = 0;
        for (double tolerance = 1; tolerance > 1e-5; tolerance /= 2) {
            const std::size_t rings = planned(tuft, {.tolerance = tolerance, .rings = {}, .sides = 12}).rings.size();
            EXPECT_GE(rings, before) << tuft.name << ", tolerance " << tolerance;
            before = rings;
        }
    }
}

TEST(Tuft, RingsAndSidesAreAsManyAsAsked) {
    for (const auto& [rings, sides] : {std::pair{2, 3}, {7, 5}, {64, 64}}) {
        for (const double widest : {40.0, 100.0}) {
            Tuft tuft = test::ponytail();
            tuft.widest_at = widest;
            const MeshPlan plan = planned(tuft, {.tolerance = 3e-4, .rings = rings, .sides = sides});
            EXPECT_EQ(plan.rings.size(), static_cast<std::size_t>(rings));
            EXPECT_EQ(plan.sides, sides);
            const auto caps = static_cast<std::size_t>(widest == 100 ? 1 : 0),
                       row = static_cast<std::size_t>(sides) + 1;
            EXPECT_EQ(plan.vertex_count(), 2 + (plan.rings.size() + caps) * row);
            EXPECT_EQ(plan.index_count(), 6 * plan.rings.size() * static_cast<std::size_t>(sides));
            expect_sound(tuft, {.tolerance = 3e-4, .rings = rings, .sides = sides});
        }
    }
}

TEST(Tuft, EveryBoneHasARing) {
    Tuft tuft = straight();
    tuft.joints = 64;
    const MeshPlan plan = planned(tuft, {.tolerance = 1, .rings = {}, .sides = 3});
    for (int bone = 0; bone < 64; ++bone) {
        EXPECT_TRUE(std::ranges::any_of(plan.rings.along(), [&](const double along) {
            return along >= bone / 64.0 && along <= (bone + 1) / 64.0;
        })) << bone;
    }
}

TEST(Tuft, SixteenAndThirtyTwoBitIndicesAgree) {
    const MeshPlan plan = planned(test::fringe());
    std::vector<std::uint16_t> narrow(plan.index_count());
    std::vector<std::uint32_t> wide(plan.index_count());
    write_indices(plan, std::span(narrow), 100);
    write_indices(plan, std::span(wide), 100);
    for (std::size_t i = 0; i < wide.size(); ++i) ASSERT_EQ(narrow[i], wide[i]) << i;
    EXPECT_EQ(*std::min_element(wide.begin(), wide.end()), 100U);
    EXPECT_EQ(*std::max_element(wide.begin(), wide.end()), 100U + plan.vertex_count() - 1);
}

TEST(Tuft, BonesAreCountedFromTheFirstOfItsOwn) {
    const MeshPlan plan = planned(test::fringe());
    Mesh mesh = to_mesh(plan);
    const Mesh own = mesh;
    write_vertices(plan, {mesh.positions, mesh.normals, mesh.uvs, mesh.joints, mesh.weights, 500});
    EXPECT_EQ(mesh.positions, own.positions);
    for (std::size_t i = 0; i < mesh.joints.size(); ++i) {
        EXPECT_EQ(mesh.joints[i], own.weights[i] > 0 ? own.joints[i] + 500 : 0) << i;
    }
}

TEST(Tuft, EllipseIsFlatTowardsTheHead) {
    Tuft tuft = straight();  // d = 40: 4 cm across
    tuft.section = Section::kEllipse;
    tuft.flatness = 0.75;
    const MeshPlan plan = planned(tuft, {}, bald());
    EXPECT_NEAR(extent(plan, widest_ring(plan), &Vec3::y), 0.01, 1e-7);
    EXPECT_NEAR(extent(plan, widest_ring(plan), &Vec3::z), 0.04, 1e-7);
}

TEST(Tuft, RollOf90DegreesStandsAnEllipseOnItsEdge) {
    Tuft tuft = straight();
    tuft.section = Section::kEllipse;
    tuft.flatness = 0.75;
    tuft.roll_deg = 90;
    const MeshPlan plan = planned(tuft, {}, bald());
    EXPECT_NEAR(extent(plan, widest_ring(plan), &Vec3::y), 0.04, 1e-7);
    EXPECT_NEAR(extent(plan, widest_ring(plan), &Vec3::z), 0.01, 1e-7);
}

TEST(Tuft, TwistTurnsTheSectionEvenlyFromRootToTip) {
    Tuft tuft = straight();
    tuft.twist_deg = 90;
    const MeshPlan plan = planned(tuft, {}, bald());
    for (std::size_t i = 0; i < plan.rings.size(); ++i) {
        const Ring ring = plan.rings[i];
        const double angle = ring.along * kPi / 2;  // counter-clockwise about the tangent, +X: from +Y to +Z
        EXPECT_TRUE(are_near(ring.frame.normal, {0, std::cos(angle), std::sin(angle)}, 1e-12)) << ring.along;
    }
}

TEST(Tuft, ChainKnowsWhereOutwardIs) {
    const Result<PlannedTuft> plan = plan_tuft(test::fringe(), {}, {}, {});
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->chain.name, "fringe");
    EXPECT_TRUE(are_near(plan->chain.outward.value(), normalized(test::fringe().points.front()), 1e-15));
    EXPECT_FALSE(check_chain(plan->chain, {}));
}

TEST(CheckTuft, RefusesWithCodeAndField) {
    const struct {
        const char* name;
        std::function<void(Tuft&)> change;
        ErrorCode code;
        const char* field;
    } cases[] = {
        {"no points", [](Tuft& t) { t.points.clear(); }, ErrorCode::kTooFew, "/points"},
        {"one point", [](Tuft& t) { t.points.resize(1); }, ErrorCode::kTooFew, "/points"},
        {"too many points", [](Tuft& t) { t.points.resize(1025); }, ErrorCode::kTooMany, "/points"},
        {"a point not a number", [](Tuft& t) { t.points[2].y = kNaN; }, ErrorCode::kNotFinite, "/points/2/1"},
        {"a point far away", [](Tuft& t) { t.points[1].z = -2e6; }, ErrorCode::kOutOfRange, "/points/1/2"},
        {"root at the center", [](Tuft& t) { t.points[0] = {}; }, ErrorCode::kDegenerate, "/points/0"},
        {"no length",
         [](Tuft& t) {
             t.points.assign(5, {0, 0.1, 0});
         },
         ErrorCode::kDegenerate, "/points"},
        {"diameter too small", [](Tuft& t) { t.diameter = 0.5; }, ErrorCode::kOutOfRange, "/diameter"},
        {"diameter not a number", [](Tuft& t) { t.diameter = kNaN; }, ErrorCode::kNotFinite, "/diameter"},
        {"widest before the root", [](Tuft& t) { t.widest_at = 0; }, ErrorCode::kOutOfRange, "/widest_at"},
        {"widest beyond the tip", [](Tuft& t) { t.widest_at = 101; }, ErrorCode::kOutOfRange, "/widest_at"},
        {"flatter than flat", [](Tuft& t) { t.flatness = 1; }, ErrorCode::kOutOfRange, "/flatness"},
        {"a flat circle", [](Tuft& t) { t.section = Section::kCircle; }, ErrorCode::kConflict, "/flatness"},
        {"twist too strong", [](Tuft& t) { t.twist_deg = 4000; }, ErrorCode::kOutOfRange, "/twist_deg"},
        {"roll too strong", [](Tuft& t) { t.roll_deg = -361; }, ErrorCode::kOutOfRange, "/roll_deg"},
        {"no joints", [](Tuft& t) { t.joints = 0; }, ErrorCode::kOutOfRange, "/joints"},
        {"too many joints", [](Tuft& t) { t.joints = 65; }, ErrorCode::kOutOfRange, "/joints"},
        {"phase not a number", [](Tuft& t) { t.phase = kNaN; }, ErrorCode::kNotFinite, "/phase"},
        {"no cycles", [](Tuft& t) { t.cycles = 0; }, ErrorCode::kOutOfRange, "/cycles"},
    };
    for (const auto& wrong : cases) {
        Tuft tuft = test::fringe();
        wrong.change(tuft);
        EXPECT_TRUE(is_refused(check_tuft(tuft, {}, {}), wrong.code, wrong.field)) << wrong.name;
        EXPECT_TRUE(is_refused(plan_tuft(tuft, {}, {}, {}), wrong.code, wrong.field)) << wrong.name;
    }
}

TEST(CheckDetail, RefusesWithCodeAndField) {
    const auto check = [](const MeshDetail& detail) { return check_detail(detail, {}); };
    EXPECT_FALSE(check({}));
    EXPECT_TRUE(is_refused(check({.tolerance = 0, .rings = {}, .sides = 12}), ErrorCode::kOutOfRange, "/tolerance"));
    EXPECT_TRUE(is_refused(check({.tolerance = kNaN, .rings = {}, .sides = 12}), ErrorCode::kNotFinite, "/tolerance"));
    EXPECT_TRUE(is_refused(check({.tolerance = 1e-3, .rings = 1, .sides = 12}), ErrorCode::kOutOfRange, "/rings"));
    EXPECT_TRUE(is_refused(check({.tolerance = 1e-3, .rings = {}, .sides = 2}), ErrorCode::kOutOfRange, "/sides"));
    EXPECT_TRUE(is_refused(check({.tolerance = 1e-3, .rings = {}, .sides = 65}), ErrorCode::kOutOfRange, "/sides"));
}

TEST(PlanTuft, RefusesMoreRingsThanAllowed) {
    Limits limits;
    limits.rings_per_tuft = 10;
    EXPECT_TRUE(is_refused(plan_tuft(test::ponytail(), {}, {}, limits), ErrorCode::kTooMany, ""));
    EXPECT_TRUE(plan_tuft(test::ponytail(), {}, {.tolerance = 3e-4, .rings = 10, .sides = 12}, limits));
}

}  // namespace
}  // namespace tuftwave
