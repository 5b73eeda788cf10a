#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "core/real_heads.hpp"
#include "core/real_strokes.hpp"
#include "core/support.hpp"
#include "tuftwave/curve.hpp"
#include "tuftwave/fill.hpp"

// Fills between strokes and on heads that nobody in this project made.
namespace tuftwave::test {
namespace {

double drawn_length(const std::vector<Vec3>& points) {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += length(points[i] - points[i - 1]);
    return sum;
}

/// Sorts strokes from one ear over the front to the other, so that neighbours in the list are neighbours on the head.
void sort_about_head(std::vector<Tuft>& strokes, const HeadFrame& frame) {
    std::sort(strokes.begin(), strokes.end(), [&](const Tuft& a, const Tuft& b) {
        return bearing_of(frame.to_head(a.points[0])).azimuth < bearing_of(frame.to_head(b.points[0])).azimuth;
    });
}

/// Whether a filled tuft looks like the two that it lies between: as long, and on its way from the one to the other.
void expect_likeness(const Tuft& tuft, const FillPlan& plan, const HeadFrame& frame) {
    const auto& [a, b] = plan.strokes;
    ASSERT_EQ(tuft.points.size(), a.size());
    const double slack = 1e-12;
    EXPECT_GE(drawn_length(tuft.points), std::min(drawn_length(a), drawn_length(b)) - slack);
    EXPECT_LE(drawn_length(tuft.points), std::max(drawn_length(a), drawn_length(b)) + slack);
    double bow = 0;  // metres that the way over the new stroke is longer than the straight one
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vec3 point = frame.to_head(tuft.points[i]);
        bow = std::max(bow, length(point - a[i]) + length(point - b[i]) - length(a[i] - b[i]));
    }
    // The largest in the data is 6.4 cm, between strokes that curl to opposite sides with their tips 12 cm apart.
    EXPECT_LT(bow, 0.07);
}

TEST(RealFills, BetweenNeighboursAreLikeTheirNeighbours) {
    Head head;
    head.center = {0, 0.1, 0};
    const HeadFrame frame(head);
    FillSettings settings;
    settings.direction = FillDirection::kShorter;
    settings.tufts_per_meter = 1000;
    std::size_t pairs = 0, unequal = 0, tufts = 0;
    for (const std::string character : {"Vita", "Sendagaya_Shibu", "Sakurada_Fumiriya"}) {
        for (auto& [group, strokes] : vroid_groups(character)) {
            sort_about_head(strokes, frame);
            for (std::size_t i = 1; i < strokes.size(); ++i) {
                SCOPED_TRACE(strokes[i - 1].name + " and " + strokes[i].name);
                const Result<FillPlan> plan = plan_fill(strokes[i - 1], &strokes[i], settings, head, {});
                ASSERT_TRUE(plan) << plan.error().field;
                const Filled fill = *make_fill(*plan, head, nullptr, {}, InOrder{}, {});
                for (const Tuft& tuft : fill.tufts) {
                    EXPECT_FALSE(check_tuft(tuft, head, {}));
                    expect_likeness(tuft, *plan, frame);
                }
                const bool is_unequal = strokes[i - 1].points.size() != strokes[i].points.size();
                EXPECT_EQ(fill.report.is_resampled[0], is_unequal);
                ++pairs;
                unequal += is_unequal;
                tufts += fill.tufts.size();
            }
        }
    }
    EXPECT_EQ(pairs, 170u);
    EXPECT_EQ(unequal, 58u);
    EXPECT_GT(tufts, 1000u);
}

/// Distance to the nearest triangle that a point is over, by trying them all.
double distance_to(const ScalpMesh& mesh, const Vec3& point) {
    constexpr double kEdge = 1e-6;  // of a triangle's size: a root may lie on an edge
    double nearest = 1e9;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vec3 &a = mesh.positions[i], &b = mesh.positions[j], &c = mesh.positions[k];
        const Vec3 normal = cross(b - a, c - a);
        const double size = dot(normal, normal);
        const Vec3 foot = point - dot(point - a, normal) / size * normal;
        if (dot(cross(b - a, foot - a), normal) < -kEdge * size) continue;
        if (dot(cross(c - b, foot - b), normal) < -kEdge * size) continue;
        if (dot(cross(a - c, foot - c), normal) < -kEdge * size) continue;
        nearest = std::min(nearest, length(point - foot));
    }
    return nearest;
}

/// A lock that stands off the head and then hangs. @param azimuth_deg, elevation_deg  of its root
Tuft hanging_lock(const Head& head, const Scalp& scalp, const double azimuth_deg, const double elevation_deg) {
    const Vec3 direction = vector_towards({azimuth_deg * kRadiansPerDegree, elevation_deg * kRadiansPerDegree});
    const Vec3 out = vector_towards({azimuth_deg * kRadiansPerDegree, 0});
    const Vec3 root = *scalp.distance_towards(direction) * direction;
    const HeadFrame frame(head);
    Tuft tuft = tuft_along("lock", {});
    for (const Vec3& point : {root, root + 0.03 * out - Vec3{0, 0, 0.01}, root + 0.05 * out - Vec3{0, 0, 0.06},
                              root + 0.05 * out - Vec3{0, 0, 0.16}})
        tuft.points.push_back(frame.to_model(point));
    return tuft;
}

/// Places along a tuft's centre line in the head's frame, evenly from its sunk root to its tip.
std::vector<Vec3> centre_line(const Tuft& tuft, const Head& head, const int pieces) {
    std::vector<Vec3> points{sunk_root(head, tuft.points.front())};
    points.insert(points.end(), tuft.points.begin(), tuft.points.end());
    const Curve curve(points);
    std::vector<Vec3> places;
    for (int i = 0; i <= pieces; ++i)
        places.push_back(HeadFrame(head).to_head(curve.at(curve.arc_length() * i / pieces).point));
    return places;
}

/// MakeHuman's head, and what hair grows on there: its own scalp primitive, or all of its skin.
class RingsOnAHead : public testing::TestWithParam<const char*> {
  protected:
    RingsOnAHead() {
        head_.center = {0, 1.56, 0.05};
        ScalpMesh scalp = mpfb_head("scalp");
        if (GetParam() == std::string("skin")) {
            const ScalpMesh skin = mpfb_head("skin");  // the primitives share their positions
            scalp.triangles.insert(scalp.triangles.end(), skin.triangles.begin(), skin.triangles.end());
        }
        head_.scalp = scalp;
    }

    /// Largest depth of a tuft's line in the scalp behind its root where its parent's is outside, metres.
    /// @param above  only places higher than this over the head's center count, metres
    double deepest(const Tuft& tuft, const Tuft& parent, const Scalp& scalp, const double above) const {
        constexpr int kPieces = 400;  // not a multiple of the places where core looks
        const std::vector<Vec3> line = centre_line(tuft, head_, kPieces), other = centre_line(parent, head_, kPieces);
        const double sunk = length(HeadFrame(head_).to_head(tuft.points.front()) - line[0]);
        double deepest = 0;
        for (std::size_t i = 1; i < line.size(); ++i) {
            if (line[i].z < above || length(line[i] - line[0]) <= sunk || scalp.way_out(other[i])) continue;
            deepest = std::max(deepest, length(scalp.way_out(line[i]).value_or(Vec3{})));
        }
        return deepest;
    }

    Head head_;
};

TEST_P(RingsOnAHead, HaveTheirRootsOnItAndTheirLinesOutsideOfIt) {
    // The scalp is open below. The skin is open below, too, and at the eyes, and its mouth is hollow. A line that
    // passes by such an edge is found inside or outside from one place to the next; well above it there is no such
    // doubt.
    constexpr double kAnywhere = -1, kAtAnEdge = 2.5e-3;  // metres
    const double well_above = GetParam() == std::string("skin") ? 0.03 : -0.06, between_places = 5e-4;
    const Scalp scalp = *Scalp::of(head_);
    FillSettings settings;
    settings.density = {60.0, 60.0, 70.0};
    std::size_t tufts = 0, moved_out = 0, inside = 0;
    for (const double azimuth_deg : {-90.0, 0.0, 70.0, 170.0}) {
        for (const double elevation_deg : {40.0, 55.0, 70.0}) {
            const Tuft drawn = hanging_lock(head_, scalp, azimuth_deg, elevation_deg);
            settings.jitter_seed = tufts;
            const FillPlan plan = *plan_fill(drawn, nullptr, settings, head_, {});
            const Filled ring = *make_fill(plan, head_, &scalp, {}, InOrder{}, {});
            for (const Tuft& tuft : ring.tufts) {
                SCOPED_TRACE(tuft.name + " at " + std::to_string(azimuth_deg) + " " + std::to_string(elevation_deg));
                EXPECT_LT(distance_to(std::get<ScalpMesh>(head_.scalp), tuft.points.front()), 1e-6);
                EXPECT_LT(deepest(tuft, drawn, scalp, well_above), between_places);
                EXPECT_LT(deepest(tuft, drawn, scalp, kAnywhere), kAtAnEdge);
            }
            tufts += ring.tufts.size();
            moved_out += ring.report.moved_out;
            inside += ring.report.inside;
        }
    }
    EXPECT_GT(tufts, 500u);
    EXPECT_GT(moved_out, 50u);  // the head is no sphere
    EXPECT_LT(inside, tufts / 20);
}

INSTANTIATE_TEST_SUITE_P(RealFills, RingsOnAHead, testing::Values("scalp", "skin"));

}  // namespace
}  // namespace tuftwave::test
