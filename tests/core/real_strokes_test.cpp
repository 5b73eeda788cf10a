#include "real_strokes.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "mesh_invariants.hpp"
#include "ring_invariants.hpp"
#include "support.hpp"
#include "tuftwave/hairstyle.hpp"
#include "welded_mesh.hpp"

namespace tuftwave {
namespace {

/// What holds for everything that people and programs really drew: the mesh is a closed sphere without a fold.
void expect_sound(const Tuft& tuft, const Head& head) {
    const Result<PlannedTuft> plan = plan_tuft(tuft, head, {}, {});
    ASSERT_TRUE(plan) << tuft.name << ": " << plan.error().field;
    const Mesh mesh = to_mesh(plan->mesh);
    EXPECT_TRUE(test::is_finite_mesh(mesh)) << tuft.name;
    EXPECT_TRUE(test::is_sphere(test::welded(mesh))) << tuft.name;
    EXPECT_TRUE(test::has_unit_normals(mesh)) << tuft.name;
    EXPECT_LT(test::share_turned_away(mesh), 0.01) << tuft.name;  // next to creases
    EXPECT_GT(test::volume(mesh), 0) << tuft.name;
    EXPECT_TRUE(test::runs_forwards(plan->mesh, mesh)) << tuft.name;
    EXPECT_TRUE(test::has_no_spikes(plan->mesh, mesh)) << tuft.name;
    EXPECT_TRUE(test::has_sound_weights(mesh, tuft.joints)) << tuft.name;
    EXPECT_FALSE(check_chain(plan->chain, {})) << tuft.name;
}

struct Source {
    const char* name;
    std::size_t tufts;
    std::vector<Tuft> (*read)(const std::string& name);
    Vec3 center;  ///< of the head
};

const Source kSources[] = {
    {"Vita", 65, test::vroid_tufts, {}},
    {"Sendagaya_Shibu", 46, test::vroid_tufts, {}},
    {"Sakurada_Fumiriya", 83, test::vroid_tufts, {}},
    {"tail", 255, test::tressfx_strands, {0, 1.16, 0}},
    {"back", 517, test::tressfx_strands, {0, 1.16, 0}},
    {"front_top", 876, test::tressfx_strands, {0, 1.16, 0}},
};

TEST(RealStrokes, AllBecomeSoundTufts) {
    for (const Source& source : kSources) {
        Head head;
        head.center = source.center;
        const std::vector<Tuft> tufts = source.read(source.name);
        ASSERT_EQ(tufts.size(), source.tufts) << source.name << " in " << test::kDataDirectory;
        for (const Tuft& tuft : tufts) expect_sound(tuft, head);
    }
}

TEST(RealStrokes, AWholeHeadMoves) {
    Hairstyle hairstyle;
    hairstyle.tufts = test::vroid_tufts("Vita");
    hairstyle.motion = Motion{};
    hairstyle.motion->one_sided = true;
    const Result<HairPlan> plan = plan_hairstyle(hairstyle, {}, InOrder{}, {});
    ASSERT_TRUE(plan) << plan.error().field;
    for (const ChainMotion& chain : plan->motion->chains) {
        for (const Quat& rotation : chain.rotations) EXPECT_NEAR(dot(rotation, rotation), 1, 1e-12);
    }
}

}  // namespace
}  // namespace tuftwave
