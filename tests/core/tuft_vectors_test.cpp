#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "real_strokes.hpp"
#include "samples.hpp"
#include "support.hpp"
#include "tuftwave/tuft.hpp"

// A tuft has the same bits whatever vectors the machine has.
namespace tuftwave {
namespace {

std::vector<Tuft> tufts_of_all_kinds() {
    std::vector<Tuft> tufts = test::all_tufts();
    const std::vector<Tuft> tight = test::tight_tufts();
    tufts.insert(tufts.end(), tight.begin(), tight.end());
    for (const auto& [group, strokes] : test::vroid_groups("Vita"))
        tufts.insert(tufts.end(), strokes.begin(), strokes.end());
    constexpr Taper kTapers[] = {Taper::kSine, Taper::kLinear, Taper::kSmooth, Taper::kRound};
    test::Random random(11);
    for (std::size_t i = 0; i < tufts.size(); ++i) {
        Tuft& tuft = tufts[i];
        tuft.taper = kTapers[i % 4];
        if (i % 7 == 0) tuft.widest_at = 100;
        if (i % 3 != 0) continue;
        tuft.section = Section::kEllipse;
        tuft.flatness = random.between(0, 0.98);
        tuft.twist_deg = random.between(-720, 720);
        tuft.roll_deg = random.between(-180, 180);
    }
    return tufts;
}

void expect_same(const Tuft& tuft, const MeshDetail& detail, Vectors vectors) {
    const Result<PlannedTuft> narrow = plan_tuft(tuft, {}, detail, {}, Vectors::kNarrow);
    const Result<PlannedTuft> wide = plan_tuft(tuft, {}, detail, {}, vectors);
    ASSERT_TRUE(narrow && wide) << tuft.name;
    EXPECT_EQ(narrow->chain.nodes, wide->chain.nodes) << tuft.name;
    EXPECT_EQ(narrow->chain.rest_rotations, wide->chain.rest_rotations) << tuft.name;
    EXPECT_EQ(narrow->mesh.reach, wide->mesh.reach) << tuft.name;
    const Mesh a = to_mesh(narrow->mesh, Vectors::kNarrow), b = to_mesh(wide->mesh, vectors);
    EXPECT_EQ(a.positions, b.positions) << tuft.name;
    EXPECT_EQ(a.normals, b.normals) << tuft.name;
    EXPECT_EQ(a.uvs, b.uvs) << tuft.name;
    for (const float number : a.normals) ASSERT_TRUE(std::isfinite(number)) << tuft.name;
}

TEST(TuftVectors, ChangeNoBit) {
    if (usable_vectors().size() == 1) GTEST_SKIP() << "this CPU has no wide vectors";
    const std::vector<Tuft> tufts = tufts_of_all_kinds();
    EXPECT_GT(tufts.size(), 20u);
    for (const Vectors vectors : usable_vectors().subspan(1)) {
        for (const Tuft& tuft : tufts) {
            for (const int sides : {3, 8, 12, 13, 64})
                expect_same(tuft, {.tolerance = 3e-4, .rings = {}, .sides = sides}, vectors);
            for (const int rings : {1, 7, 64, 200})
                expect_same(tuft, {.tolerance = 3e-4, .rings = rings, .sides = 12}, vectors);
        }
    }
}

}  // namespace
}  // namespace tuftwave
