#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "mesh_invariants.hpp"
#include "samples.hpp"
#include "support.hpp"
#include "tuftwave/elementary.hpp"
#include "tuftwave/tuft.hpp"

// Meshes are written in floats. Here stands what they should be, in doubles.
namespace tuftwave {
namespace {

/// How far a position may be off, as a share of how far out it is: two roundings.
constexpr double kRounding = 1.5e-7;
/// How far a normal may be off, radians: a hundredth of a degree in creases and next to apexes, far less elsewhere.
constexpr double kNormalError = 2e-4;

using Points = std::vector<Vec3>;

Points corners_of(const MeshPlan& plan, std::ptrdiff_t ring) {
    const auto sides = static_cast<std::size_t>(plan.sides);
    const auto last = static_cast<std::ptrdiff_t>(plan.rings.size()) - 1;
    if (ring < 0) return Points(sides, plan.root);
    if (ring > last && !plan.flat_tip) return Points(sides, plan.tip);
    const Ring at = plan.rings[static_cast<std::size_t>(std::min(ring, last))];
    const std::span<const float> reach = plan.reach.of(static_cast<std::size_t>(std::min(ring, last)));
    Points corners;
    for (std::size_t j = 0; j < sides; ++j) {
        const auto [sine, cosine] = elementary::sincos(2 * kPi * static_cast<double>(j) / plan.sides);
        const double share = reach.empty() ? 1 : static_cast<double>(reach[j]);
        corners.push_back(at.frame.point + share * (at.half_thickness * cosine * at.frame.normal +
                                                    at.half_width * sine * at.frame.binormal()));
    }
    return corners;
}

void expect_as_in_doubles(const Tuft& tuft, const MeshDetail& detail) {
    const Result<PlannedTuft> planned = plan_tuft(tuft, {}, detail, {});
    ASSERT_TRUE(planned) << tuft.name;
    const MeshPlan& plan = planned->mesh;
    const Mesh mesh = to_mesh(plan);
    const auto sides = static_cast<std::size_t>(plan.sides);
    for (std::size_t i = 0; i < plan.rings.size(); ++i) {
        const auto ring = static_cast<std::ptrdiff_t>(i);
        const Points before = corners_of(plan, ring - 1), here = corners_of(plan, ring),
                     after = corners_of(plan, ring + 1);
        for (std::size_t j = 0; j <= sides; ++j) {
            const Vec3& corner = here[j % sides];
            const std::size_t vertex = 1 + i * (sides + 1) + j;
            ASSERT_LT(length(test::triple(mesh.positions, vertex) - corner), kRounding * length(corner))
                << tuft.name << ", ring " << i << ", column " << j;
            const Vec3 around = here[(j + 1) % sides] - here[(j + sides - 1) % sides];
            const Vec3 first = cross(around, corner - before[j % sides]),
                       second = cross(around, after[j % sides] - corner);
            const double least = 1e-8 * plan.rings[i].half_width * plan.rings[i].half_width;
            if (!(length(first) > least && length(second) > least)) continue;
            const Vec3 sum = normalized(first) + normalized(second);
            if (!(length(sum) > 0.2)) continue;
            ASSERT_LT(length(test::triple(mesh.normals, vertex) - normalized(sum)), kNormalError)
                << tuft.name << ", ring " << i << ", column " << j;
        }
    }
}

TEST(QuickSurface, IsWhatDoublesMakeOfIt) {
    std::vector<Tuft> tufts = test::all_tufts();
    const std::vector<Tuft> tight = test::tight_tufts();
    tufts.insert(tufts.end(), tight.begin(), tight.end());
    for (std::size_t i = 0; i < tufts.size(); ++i) {
        if (i % 3 != 0) continue;
        tufts[i].section = Section::kEllipse;
        tufts[i].flatness = 0.9;
        tufts[i].twist_deg = 200;
    }
    for (const Tuft& tuft : tufts) {
        for (const int sides : {3, 7, 8, 12, 64})
            expect_as_in_doubles(tuft, {.tolerance = 3e-4, .rings = {}, .sides = sides});
        for (const int rings : {1, 64, 1000})
            expect_as_in_doubles(tuft, {.tolerance = 3e-4, .rings = rings, .sides = 12});
    }
}

}  // namespace
}  // namespace tuftwave
