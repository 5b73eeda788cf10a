#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/samples.hpp"
#include "tuftwave/tuft.hpp"

// How far the corners of a folding tuft are cut back, seen through MeshPlan::reach.
namespace tuftwave::test {
namespace {

MeshPlan planned(const Tuft& tuft) { return plan_tuft(tuft, Head{}, MeshDetail{}, Limits{})->mesh; }

/// Two bends, each tighter than the tuft is thick and nearer to each other than it is wide: the smallest stroke whose
/// inner side could recover between them.
Tuft double_bend() {
    Tuft tuft =
        tuft_along("double_bend",
                   {{0, 0.1, 0}, {0, 0.18, 0}, {0.008, 0.19, 0}, {0.024, 0.19, 0}, {0.032, 0.18, 0}, {0.032, 0.1, 0}});
    tuft.diameter = 60;
    tuft.widest_at = 50;
    tuft.taper = Taper::kRound;
    return tuft;
}

TEST(Unfold, LeavesAGentleTuftWhole) {
    EXPECT_TRUE(planned(tuft_along("straight", {{0, 0.1, 0}, {0, 0.2, 0}, {0.01, 0.3, 0}})).reach.empty());
}

TEST(Unfold, CutsOnlyTheInsideOfABend) {
    const MeshPlan plan = planned(hairpin());
    ASSERT_FALSE(plan.reach.empty());
    EXPECT_LT(*std::min_element(plan.reach.begin(), plan.reach.end()), 1.0F);
    EXPECT_EQ(*std::max_element(plan.reach.begin(), plan.reach.end()), 1.0F);
}

TEST(Unfold, LeavesNoFinBetweenTwoNearBends) {
    const MeshPlan plan = planned(double_bend());
    ASSERT_FALSE(plan.reach.empty());
    const auto sides = static_cast<std::size_t>(plan.sides);
    const auto reach = [&](std::size_t ring, std::size_t corner) { return plan.reach[ring * sides + corner]; };
    std::size_t innermost = 0;  // the corner that is cut the most
    for (std::size_t at = 0; at < plan.reach.size(); ++at) {
        if (plan.reach[at] <
            *std::min_element(plan.reach.begin(), plan.reach.begin() + static_cast<std::ptrdiff_t>(at) + 1) + 1e-6F)
            innermost = at % sides;
    }
    // Along the inside the cut deepens once and recovers once: no corner stands out between two that are cut further.
    const std::size_t rings = plan.rings.size();
    for (std::size_t i = 0; i < rings; ++i) {
        float before = 1, after = 1;
        for (std::size_t k = 0; k < i; ++k) before = std::min(before, reach(k, innermost));
        for (std::size_t k = i + 1; k < rings; ++k) after = std::min(after, reach(k, innermost));
        EXPECT_LE(reach(i, innermost), std::max(before, after) + 0.05F) << "ring " << i << ", corner " << innermost;
    }
}

}  // namespace
}  // namespace tuftwave::test
