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
    EXPECT_TRUE(planned(tuft_along("straight", {{0, 0.1, 0}, {0, 0.2, 0}, {0.01, 0.3, 0}})).reach.shares.empty());
}

/// The share that is left of a corner.
float share(const MeshPlan& plan, std::size_t ring, std::size_t corner) {
    const std::span<const float> shares = plan.reach.of(ring);
    return shares.empty() ? 1 : shares[corner];
}

TEST(Unfold, CutsOnlyTheInsideOfABend) {
    const MeshPlan plan = planned(hairpin());
    const std::vector<float>& shares = plan.reach.shares;
    ASSERT_FALSE(shares.empty());
    EXPECT_LT(*std::min_element(shares.begin(), shares.end()), 1.0F);
    EXPECT_EQ(*std::max_element(shares.begin(), shares.end()), 1.0F);
}

TEST(Unfold, KeepsSharesOfTheRingsAroundABendOnly) {
    const MeshPlan plan = planned(hairpin());
    ASSERT_GT(plan.reach.row, 0U);
    EXPECT_GE(plan.reach.row, static_cast<std::size_t>(plan.sides));
    const std::size_t first = plan.reach.first_ring, count = plan.reach.shares.size() / plan.reach.row;
    EXPECT_LT(count, plan.rings.size());
    EXPECT_EQ(plan.reach.of(first).size(), plan.reach.row);
    EXPECT_EQ(plan.reach.of(first + count - 1).size(), plan.reach.row);
    EXPECT_TRUE(plan.reach.of(first + count).empty());
    if (first > 0) {
        EXPECT_TRUE(plan.reach.of(first - 1).empty());
    }
    for (std::size_t j = 0; j < static_cast<std::size_t>(plan.sides); ++j) {
        EXPECT_GT(share(plan, first, j), 0.9F) << "the cut has faded at the first ring, corner " << j;
        EXPECT_GT(share(plan, first + count - 1, j), 0.9F) << "likewise at the last one, corner " << j;
    }
}

TEST(Unfold, LeavesNoFinBetweenTwoNearBends) {
    const MeshPlan plan = planned(double_bend());
    ASSERT_FALSE(plan.reach.shares.empty());
    const std::size_t rings = plan.rings.size();
    std::size_t innermost = 0;  // the corner that is cut the most
    float least = 1;
    for (std::size_t i = 0; i < rings; ++i) {
        for (std::size_t j = 0; j < static_cast<std::size_t>(plan.sides); ++j) {
            if (share(plan, i, j) < least) innermost = j;
            least = std::min(least, share(plan, i, j));
        }
    }
    // Along the inside the cut deepens once and recovers once: no corner stands out between two that are cut further.
    for (std::size_t i = 0; i < rings; ++i) {
        float before = 1, after = 1;
        for (std::size_t k = 0; k < i; ++k) before = std::min(before, share(plan, k, innermost));
        for (std::size_t k = i + 1; k < rings; ++k) after = std::min(after, share(plan, k, innermost));
        EXPECT_LE(share(plan, i, innermost), std::max(before, after) + 0.05F)
            << "ring " << i << ", corner " << innermost;
    }
}

}  // namespace
}  // namespace tuftwave::test
