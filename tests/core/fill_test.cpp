#include "tuftwave/fill.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "samples.hpp"
#include "scalp_shapes.hpp"
#include "support.hpp"

namespace tuftwave {
namespace {

using test::are_near;
using test::is_refused;

/// A lock over the left ear and one at the back of the head, different in everything.
Tuft side_lock() {
    Tuft tuft = test::tuft_along("side", {{0.08, 0.06, 0.02}, {0.11, 0, 0.03}, {0.1, -0.1, 0.04}});
    tuft.diameter = 30;
    tuft.widest_at = 20;
    tuft.joints = 4;
    return tuft;
}

Tuft back_lock() {
    Tuft tuft = test::tuft_along("back", {{0.01, 0.075, -0.07}, {0.02, 0.02, -0.13}, {0.01, -0.11, -0.11}});
    tuft.diameter = 60;
    tuft.widest_at = 70;
    tuft.section = Section::kEllipse;
    tuft.flatness = 0.5;
    tuft.joints = 9;
    tuft.phase = 1;
    return tuft;
}

FillSettings dense() {
    FillSettings settings;
    settings.density = {100.0, 80.0, 80.0};
    return settings;
}

Filled filled(const Tuft& from, const Tuft* to, const FillSettings& settings, const Head& head = {}) {
    const Result<FillPlan> plan = plan_fill(from, to, settings, head, {});
    EXPECT_TRUE(plan) << plan.error().field;
    const auto scalp = Scalp::of(head);
    return *make_fill(*plan, head, scalp ? &*scalp : nullptr, {}, InOrder{}, {});
}

Filled filled(const Tuft& from, const Tuft& to, const FillSettings& settings, const Head& head = {}) {
    return filled(from, &to, settings, head);
}

std::size_t count_of(const Filled& filled, const FillKind kind) {
    return static_cast<std::size_t>(std::count_if(filled.tufts.begin(), filled.tufts.end(),
                                                  [kind](const Tuft& tuft) { return tuft.origin->kind == kind; }));
}

Tuft changed(Tuft tuft, const std::function<Vec3(const Vec3&)>& change) {
    for (Vec3& point : tuft.points) point = change(point);
    return tuft;
}

/// Whether two fills gave the same strokes, the first one changed.
testing::AssertionResult are_alike(const Filled& a, const Filled& b, const std::function<Vec3(const Vec3&)>& change) {
    if (a.tufts.size() != b.tufts.size())
        return testing::AssertionFailure() << a.tufts.size() << " and " << b.tufts.size() << " tufts";
    for (std::size_t i = 0; i < a.tufts.size(); ++i) {
        if (const auto near = are_near(changed(a.tufts[i], change).points, b.tufts[i].points, 1e-13); !near)
            return testing::AssertionFailure() << "tuft " << i << ": " << near.message();
        if (a.tufts[i].origin != b.tufts[i].origin) return testing::AssertionFailure() << "tuft " << i << ": origins";
    }
    return testing::AssertionSuccess();
}

const auto kSame = [](const Vec3& point) { return point; };

TEST(Fill, GivesTuftsReadyToBeEdited) {
    const Filled fill = filled(side_lock(), back_lock(), dense());
    const FillReport& report = fill.report;
    EXPECT_EQ(report.along, report.gap.along);
    EXPECT_GT(report.along, 3u);
    EXPECT_EQ(report.along, count_of(fill, FillKind::kAlong));
    EXPECT_EQ(report.crown, count_of(fill, FillKind::kCrown));
    EXPECT_EQ(report.neck, count_of(fill, FillKind::kNeck));
    for (std::size_t i = 0; i < fill.tufts.size(); ++i) {
        EXPECT_FALSE(check_tuft(fill.tufts[i], {}, {})) << i;
        EXPECT_EQ(fill.tufts[i].name, "fill_" + std::to_string(i + 1));
        EXPECT_EQ(fill.tufts[i].points.size(), 3u);
        if (i == 0) continue;
        EXPECT_LE(fill.tufts[i - 1].origin->kind, fill.tufts[i].origin->kind);
    }
}

TEST(Fill, ShapesOfTuftsAlongLieBetweenTheTwo) {
    const Tuft from = side_lock(), to = back_lock();
    const Filled fill = filled(from, to, dense());
    const double whole = static_cast<double>(fill.report.gap.along + 1);
    for (std::size_t l = 1; l <= fill.report.along; ++l) {
        const Tuft& tuft = fill.tufts[l - 1];
        const double part = static_cast<double>(l) / whole;
        EXPECT_NEAR(tuft.diameter, 30 + 30 * part, 1e-12);   // eq. (4)
        EXPECT_NEAR(tuft.widest_at, 20 + 50 * part, 1e-12);  // eq. (4)
        EXPECT_NEAR(tuft.flatness, 0.5 * part, 1e-15);
        EXPECT_EQ(tuft.section, Section::kEllipse);  // of which a circle is one
        EXPECT_EQ(tuft.joints, std::lround(4 + 5 * part));
        EXPECT_NEAR(tuft.phase, part, 1e-15);
    }
}

TEST(Fill, CopiesHaveTheirParentsShapeAndItsStrokeTurnedRigidly) {
    const Filled fill = filled(side_lock(), back_lock(), dense());
    const auto& along = fill.report.along;
    for (const Tuft& copy : fill.tufts) {
        if (!copy.origin->parent) continue;
        const auto o = static_cast<std::size_t>(*copy.origin->parent);
        const Tuft parent = o == 1 ? side_lock() : o == along + 2 ? back_lock() : fill.tufts[o - 2];
        EXPECT_EQ(copy.diameter, parent.diameter);
        EXPECT_EQ(copy.widest_at, parent.widest_at);
        for (std::size_t i = 0; i < copy.points.size(); ++i) {
            EXPECT_NEAR(length(copy.points[i]), length(parent.points[i]), 1e-15);  // the center is the origin
            if (i == 0) continue;
            EXPECT_NEAR(length(copy.points[i] - copy.points[i - 1]), length(parent.points[i] - parent.points[i - 1]),
                        1e-15);
        }
    }
}

TEST(Fill, TurnsWithTheHeadsHair) {
    // About the up axis; without the neck, whose hair line belongs to the face.
    FillSettings settings = dense();
    settings.density.neck.reset();
    settings.jitter_seed = 11;
    const Filled fill = filled(side_lock(), back_lock(), settings);
    for (const double angle : {0.1, 1.0, 3.0}) {
        const auto turn = [angle](const Vec3& point) { return rotated(turn_about({0, 1, 0}, angle), point); };
        EXPECT_TRUE(are_alike(fill, filled(changed(side_lock(), turn), changed(back_lock(), turn), settings), turn));
    }
}

TEST(Fill, MovesWithTheHead) {
    FillSettings settings = dense();
    settings.jitter_seed = 12;
    test::Random random(3);
    Head head;
    head.center = {0.3, 1.5, -0.2};
    const Quat turn = random.rotation();
    head.up = rotated(turn, {0, 1, 0});
    head.front = rotated(turn, {0, 0, 1});
    const auto move = [&](const Vec3& point) { return head.center + rotated(turn, point); };
    EXPECT_TRUE(are_alike(filled(side_lock(), back_lock(), settings),
                          filled(changed(side_lock(), move), changed(back_lock(), move), settings, head), move));
}

TEST(Fill, ClockwiseIsTheMirrorImage) {
    FillSettings settings = dense();
    const Filled fill = filled(side_lock(), back_lock(), settings);
    const auto mirror = [](const Vec3& point) { return Vec3{-point.x, point.y, point.z}; };
    settings.direction = FillDirection::kClockwise;
    EXPECT_TRUE(are_alike(fill, filled(changed(side_lock(), mirror), changed(back_lock(), mirror), settings), mirror));
}

TEST(Fill, ARingIsExactTurns) {
    FillSettings settings;
    settings.density.along = 60;
    const Filled ring = filled(side_lock(), nullptr, settings);
    ASSERT_EQ(ring.tufts.size(), 19u);  // 60 % of 32, rounded down
    for (std::size_t l = 1; l <= 19; ++l) {
        const double angle = 2 * kPi * static_cast<double>(l) / 20;
        const auto turn = [angle](const Vec3& point) { return rotated(turn_about({0, 1, 0}, angle), point); };
        EXPECT_TRUE(are_near(ring.tufts[l - 1].points, changed(side_lock(), turn).points, 1e-14)) << l;
    }
}

TEST(Fill, ARingCopiesItsTuftOnceAsPrintedTwice) {
    FillSettings settings;
    settings.density = {50.0, 60.0, {}};
    const Filled ring = filled(side_lock(), nullptr, settings);
    settings.formulas = Formulas::kAsPrinted;
    settings.spacing = Spacing::kDiameter;
    const Filled printed = filled(side_lock(), nullptr, settings);
    const std::size_t per_parent = ring.report.crown / (ring.report.along + 1);
    EXPECT_EQ(printed.report.crown, ring.report.crown + per_parent);
}

TEST(Fill, AsPrintedTheLastTuftAlongStandsOnTheSecondOne) {
    FillSettings settings;
    settings.formulas = Formulas::kAsPrinted;
    const Tuft to = test::tuft_along("to", {{-0.08, 0.06, 0.02}, {-0.11, 0, 0.03}, {-0.1, -0.1, 0.04}});
    EXPECT_TRUE(are_near(filled(side_lock(), to, settings).tufts.back().points.front(), to.points.front(), 1e-15));
    settings.formulas = Formulas::kCorrected;
    EXPECT_GT(length(filled(side_lock(), to, settings).tufts.back().points.front() - to.points.front()), 0.005);
}

TEST(Fill, OfTwoTuftsInOnePlaceIsNothing) {
    // They are two tufts without a gap between them, not one tuft whose ring would be asked for.
    Tuft twin = side_lock();
    twin.name = "twin";
    const Filled fill = filled(side_lock(), twin, FillSettings{});
    EXPECT_TRUE(fill.tufts.empty());
    EXPECT_EQ(fill.report.gap.along, 0u);
}

TEST(Fill, WithoutRoomAlongStillCopiesTheTwo) {
    FillSettings settings;
    settings.density = {{}, 50.0, 50.0};
    const Filled fill = filled(side_lock(), back_lock(), settings);
    EXPECT_EQ(fill.report.along, 0u);
    EXPECT_GT(fill.report.crown, 0u);
    for (const Tuft& copy : fill.tufts) EXPECT_TRUE(*copy.origin->parent == 1 || *copy.origin->parent == 2);
}

TEST(Fill, CrownAndNeckSwitchOffIndependently) {
    for (const double min_gap : {0.0, 0.8}) {
        FillSettings settings = dense();
        settings.jitter_seed = 4;
        settings.min_gap = min_gap;
        const Filled both = filled(side_lock(), back_lock(), settings);
        const auto with_only = [&](const FillKind kind) {
            FillSettings only = settings;
            (kind == FillKind::kCrown ? only.density.neck : only.density.crown).reset();
            Filled expected = both;
            std::erase_if(expected.tufts, [kind](const Tuft& tuft) {
                return tuft.origin->kind != FillKind::kAlong && tuft.origin->kind != kind;
            });
            return are_alike(expected, filled(side_lock(), back_lock(), only), kSame);
        };
        EXPECT_TRUE(with_only(FillKind::kCrown)) << min_gap;
        EXPECT_TRUE(with_only(FillKind::kNeck)) << min_gap;
    }
}

TEST(Fill, JitterStaysWithinNineDegreesOfTheCleanLayout) {
    FillSettings settings = dense();
    settings.density.neck.reset();  // the hair line might drop a copy from one of the two
    const Filled clean = filled(side_lock(), back_lock(), settings);
    const HeadFrame frame{Head{}};
    for (const std::uint64_t seed : {0ull, 1ull, 9007199254740991ull}) {
        settings.jitter_seed = seed;
        const Filled jittered = filled(side_lock(), back_lock(), settings);
        ASSERT_EQ(jittered.tufts.size(), clean.tufts.size());
        double farthest = 0;
        for (std::size_t i = 0; i < clean.tufts.size(); ++i) {
            const Bearing a = bearing_of(frame.to_head(clean.tufts[i].points.front()));
            const Bearing b = bearing_of(frame.to_head(jittered.tufts[i].points.front()));
            EXPECT_LE(std::abs(b.elevation - a.elevation), kPi / 20 + 1e-12);
            if (b.elevation > kPi / 2 - 1e-9) continue;  // at the pole there is no azimuth
            EXPECT_LE(std::abs(std::remainder(b.azimuth - a.azimuth, 2 * kPi)), kPi / 20 + 1e-12);
            farthest = std::max(farthest, std::abs(b.elevation - a.elevation));
        }
        EXPECT_GT(farthest, kPi / 40);  // and does not stay where it was
    }
}

TEST(Fill, IsTheSameForAnyOrderOfWork) {
    Head head;
    head.scalp = test::sphere_mesh({0, 0.01, 0}, 0.1, 10);
    FillSettings settings = dense();
    settings.jitter_seed = 5;
    settings.min_gap = 0.5;
    const auto plan = *plan_fill(side_lock(), nullptr, settings, head, {});
    const Scalp scalp = *Scalp::of(head);
    const Filled in_order = *make_fill(plan, head, &scalp, {}, InOrder{}, {});
    const auto is_same = [&](const ForEach& for_each) {
        const Filled other = *make_fill(plan, head, &scalp, {}, for_each, {});
        if (other.tufts.size() != in_order.tufts.size()) return false;
        for (std::size_t i = 0; i < other.tufts.size(); ++i) {
            if (other.tufts[i].points != in_order.tufts[i].points) return false;
        }
        return true;
    };
    EXPECT_TRUE(is_same(test::LastFirst{}));
    EXPECT_TRUE(is_same(test::EvenFirst{}));
}

TEST(Fill, MinGapLeavesNoCopyNearerThanItAllows) {
    FillSettings settings = dense();
    settings.jitter_seed = 6;
    settings.min_gap = 0.7;
    const Filled fill = filled(side_lock(), back_lock(), settings);
    EXPECT_GT(fill.report.crowded, 0u);
    std::vector<Tuft> all{side_lock(), back_lock()};
    all.insert(all.end(), fill.tufts.begin(), fill.tufts.end());
    std::size_t without = 0;
    for (const Tuft& tuft : fill.tufts) {
        if (tuft.origin->kind == FillKind::kAlong) continue;
        for (const Tuft& other : all) {
            const bool is_compared =
                !other.origin || other.origin->kind == FillKind::kAlong ||
                (other.origin->kind == tuft.origin->kind && &other - &all[2] < &tuft - &fill.tufts[0]);
            if (!is_compared) continue;
            EXPECT_GE(length(other.points.front() - tuft.points.front()), 0.7 * 0.1 * tuft.diameter / 100);
        }
        ++without;
    }
    settings.min_gap = 0;
    EXPECT_EQ(filled(side_lock(), back_lock(), settings).tufts.size() - fill.tufts.size(), fill.report.crowded);
    EXPECT_GT(without, 0u);
}

TEST(Fill, PutsRootsOnTheScalpAndTheRestAlong) {
    Head head;
    head.scalp = ScalpEllipsoid{{}, {0.09, 0.12, 0.11}};
    FillSettings settings = dense();
    const Filled bare = filled(side_lock(), back_lock(), settings);
    const Filled on_scalp = filled(side_lock(), back_lock(), settings, head);
    ASSERT_EQ(bare.tufts.size(), on_scalp.tufts.size());
    for (std::size_t i = 0; i < bare.tufts.size(); ++i) {
        const Vec3 root = on_scalp.tufts[i].points.front();
        EXPECT_NEAR(length({root.x / 0.09, root.y / 0.12, root.z / 0.11}), 1, 1e-12);
        EXPECT_LT(length(cross(root, bare.tufts[i].points.front())), 1e-15);  // on the same ray
    }
}

TEST(Fill, WhereTheScalpMeshEndsNoHairGrows) {
    Head head;
    ScalpMesh half = test::sphere_mesh({}, 0.1, 16);
    std::erase_if(half.triangles, [&](const auto& t) { return half.positions[t[0]].x < -0.001; });
    head.scalp = half;
    FillSettings settings;
    settings.density.along = 100;
    const Filled ring = filled(side_lock(), nullptr, settings, head);
    EXPECT_EQ(ring.report.along + ring.report.off_scalp, 32u);
    EXPECT_GT(ring.report.off_scalp, 12u);
    for (const Tuft& tuft : ring.tufts) EXPECT_GT(tuft.points.front().x, -0.012);  // within a triangle of the edge
}

TEST(Fill, UnequalStrokesAreResampledToTheLongerOne) {
    Tuft to = back_lock();
    to.points.insert(to.points.begin() + 1, {0.015, 0.06, -0.1});
    const Filled fill = filled(side_lock(), to, FillSettings{});
    EXPECT_EQ(fill.report.is_resampled, (std::array<bool, 2>{true, true}));
    for (const Tuft& tuft : fill.tufts) EXPECT_EQ(tuft.points.size(), 4u);
    EXPECT_EQ(filled(side_lock(), back_lock(), FillSettings{}).report.is_resampled,
              (std::array<bool, 2>{false, false}));
}

TEST(Fill, UnequalStrokesAreRefusedWhereResamplingIsOff) {
    Tuft to = back_lock();
    to.points.pop_back();
    FillSettings settings;
    settings.resample = false;
    const Tuft from = side_lock();
    EXPECT_TRUE(is_refused(plan_fill(from, &to, settings, {}, {}), ErrorCode::kConflict, "/to/points"));
    settings.resample.reset();
    settings.formulas = Formulas::kAsPrinted;
    EXPECT_TRUE(is_refused(plan_fill(from, &to, settings, {}, {}), ErrorCode::kUndefinedAsPrinted, "/to/points"));
    settings.resample = true;  // an override of what as_printed implies
    EXPECT_TRUE(plan_fill(from, &to, settings, {}, {}));
}

TEST(Fill, NamesTheTuftThatIsWrong) {
    Tuft wrong = back_lock();
    wrong.diameter = 0;
    const Tuft right = side_lock();
    EXPECT_TRUE(is_refused(plan_fill(wrong, &right, {}, {}, {}), ErrorCode::kOutOfRange, "/from/diameter"));
    EXPECT_TRUE(is_refused(plan_fill(right, &wrong, {}, {}, {}), ErrorCode::kOutOfRange, "/to/diameter"));
}

TEST(Fill, OfTooManyTuftsSaysHowManyWouldHaveCome) {
    FillSettings settings = dense();
    const Tuft from = side_lock(), to = back_lock();
    const std::size_t would_come = filled(from, to, settings).tufts.size();
    Limits limits;
    limits.tufts = would_come;
    EXPECT_TRUE(plan_fill(from, &to, settings, {}, limits));
    limits.tufts = would_come - 1;
    const auto refused = plan_fill(from, &to, settings, {}, limits);
    ASSERT_TRUE(is_refused(refused, ErrorCode::kTooMany, "/density"));
    EXPECT_EQ(std::get<double>(refused.error().given), static_cast<double>(would_come));
    limits = {};
    limits.points = 3 * would_come - 1;
    EXPECT_TRUE(is_refused(plan_fill(from, &to, settings, {}, limits), ErrorCode::kTooMany, "/density"));
}

TEST(Fill, OfAStrokeThatLeavesTheWorldAsItTurnsIsRefused) {
    // Drawn at the edge of what a coordinate may be, about a center at the other edge.
    Head head;
    head.center = {-1e6, 0, 0};
    const Tuft far = test::tuft_along("far", {{9e5, 0, 0}, {9e5, -1e5, 0}});
    const auto plan = *plan_fill(far, nullptr, {}, head, {});
    EXPECT_TRUE(is_refused(make_fill(plan, head, nullptr, {}, InOrder{}, {}), ErrorCode::kOutOfRange, "/from/points"));
}

TEST(Fill, WhereTheScalpRunsThroughTheCenterNoHairGrows) {
    Head head;
    ScalpMesh plane;
    plane.positions = {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}};
    plane.triangles = {{0, 1, 2}};
    head.scalp = plane;
    const Filled ring = filled(side_lock(), nullptr, dense(), head);
    EXPECT_TRUE(ring.tufts.empty());
    EXPECT_GT(ring.report.off_scalp, 0u);
}

TEST(Fill, StopsWhenItIsTold) {
    const auto plan = *plan_fill(side_lock(), nullptr, {}, {}, {});
    std::stop_source source;
    source.request_stop();
    EXPECT_TRUE(is_refused(make_fill(plan, {}, nullptr, {}, InOrder{}, source.get_token()), ErrorCode::kCancelled, ""));
}

}  // namespace
}  // namespace tuftwave
