#include "tuftwave/fill_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "support.hpp"
#include "tuftwave/random.hpp"

namespace tuftwave {
namespace {

constexpr double kDegree = kRadiansPerDegree;
constexpr std::size_t kAll = 1'000'000;
using Roots = std::vector<Bearing>;

/// Three parents at the back of the head, where the hair line is 60 degrees down.
const Roots kBack{{60 * kDegree, 20 * kDegree}, {90 * kDegree, 25 * kDegree}, {120 * kDegree, 30 * kDegree}};

Rows rows(const Roots& roots, const Densities& density, std::optional<std::uint64_t> seed = {}) {
    return lay_rows(roots, true, density, seed, kAll);
}

std::vector<Placement> of_kind(const Rows& rows, const FillKind kind) {
    std::vector<Placement> found;
    for (const Placement& placement : rows.placements) {
        if (placement.origin.kind == kind) found.push_back(placement);
    }
    return found;
}

bool same(const Placement& a, const Placement& b) {
    return a.origin == b.origin && a.parent == b.parent && a.turn.azimuth == b.turn.azimuth &&
           a.turn.elevation == b.turn.elevation;
}

TEST(Rows, AlongAreTheParentsBetweenTheTwo) {
    const Rows along = rows(kBack, {});
    ASSERT_EQ(along.placements.size(), 1u);
    EXPECT_EQ(along.placements[0].origin, (Origin{FillKind::kAlong, 1, {}}));
    EXPECT_EQ(along.placements[0].parent, 1u);
    EXPECT_EQ(along.placements[0].turn.elevation, 0);
}

TEST(Rows, CrownCopiesStandEquationSevenApartBelowThePole) {
    // m = 100 gives 9 degrees, m = 50 gives 49.5.
    const Rows dense = rows(kBack, {50.0, 100.0, {}});
    const std::vector<Placement> crown = of_kind(dense, FillKind::kCrown);
    ASSERT_EQ(crown.size(), 7u + 7u + 6u);  // (90 - 20) / 9, (90 - 25) / 9, (90 - 30) / 9
    for (const Placement& copy : crown) EXPECT_NEAR(copy.turn.elevation, copy.origin.index * 9 * kDegree, 1e-14);
    EXPECT_EQ(crown.front().origin, (Origin{FillKind::kCrown, 1, 1}));
    EXPECT_EQ(crown.back().origin, (Origin{FillKind::kCrown, 6, 3}));
    EXPECT_EQ(of_kind(rows(kBack, {50.0, 50.0, {}}), FillKind::kCrown).size(), 3u);
}

TEST(Rows, ACopyAtThePoleItselfIsNotMade) {
    // From 0 in steps of 9 degrees the tenth copy would stand at 90; the rule is strict.
    EXPECT_EQ(of_kind(rows({{0, 0}, {1, 0}}, {50.0, 100.0, {}}), FillKind::kCrown).size(), 2 * 9u);
}

TEST(Rows, NeckCopiesEndAtTheHairLine) {
    const Rows dense = rows(kBack, {50.0, {}, 100.0});
    // Down to above -60 degrees: from 20 eight steps of 9, from 25 nine, and from 30 nine, since the tenth is on the
    // line.
    EXPECT_EQ(of_kind(dense, FillKind::kNeck).size(), 8u + 9u + 9u);
    EXPECT_EQ(dense.beyond_hairline, 4u + 3u + 4u);  // the rest of the way down to the other pole
    // Above the face the line is at 0.
    EXPECT_EQ(of_kind(rows({{-kPi / 2, 0.5}, {-kPi / 2 + 0.1, 0.5}}, {50.0, {}, 100.0}), FillKind::kNeck).size(),
              2 * 3u);
}

TEST(Rows, CrownAndNeckDoNotKnowOfEachOther) {
    const Rows both = rows(kBack, {50.0, 70.0, 80.0}, 5);
    for (const auto& [density, kind] : {std::pair<Densities, FillKind>{{50.0, 70.0, {}}, FillKind::kCrown},
                                        std::pair<Densities, FillKind>{{50.0, {}, 80.0}, FillKind::kNeck}}) {
        const auto alone = of_kind(rows(kBack, density, 5), kind), together = of_kind(both, kind);
        ASSERT_EQ(alone.size(), together.size());
        for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_TRUE(same(alone[i], together[i])) << i;
    }
}

TEST(Rows, OnARingTheLastRootIsTheFirstAgainAndHasNoCopies) {
    const Rows ring = lay_rows(kBack, false, {50.0, 100.0, {}}, {}, kAll);
    EXPECT_EQ(of_kind(ring, FillKind::kCrown).size(), 7u + 7u);
}

TEST(Rows, JitterIsThePublishedLayoutOfPhilox) {
    const std::uint64_t seed = 0x123456789abcdef;
    const Rows jittered = rows(kBack, {50.0, 60.0, 60.0}, seed), clean = rows(kBack, {50.0, 60.0, 60.0});
    const auto offset = [&](std::uint32_t o, std::uint32_t y, std::uint32_t kind) {
        const auto words = philox4x32({o, y, kind, 0}, {0x89abcdef, 0x1234567});
        return Bearing{(2 * unit_interval(words[0], words[1]) - 1) * (kPi / 20),
                       (2 * unit_interval(words[2], words[3]) - 1) * (kPi / 20)};
    };
    const Bearing along = offset(1, 0, 0);
    EXPECT_EQ(jittered.placements[0].turn.azimuth, along.azimuth);
    EXPECT_NEAR(jittered.placements[0].turn.elevation, along.elevation, 1e-15);
    const std::vector<Placement> crown = of_kind(jittered, FillKind::kCrown);
    const std::vector<Placement> clean_crown = of_kind(clean, FillKind::kCrown);
    ASSERT_EQ(crown.size(), clean_crown.size());
    for (std::size_t i = 0; i < crown.size(); ++i) {
        const Bearing expected = offset(static_cast<std::uint32_t>(*crown[i].origin.parent),
                                        static_cast<std::uint32_t>(crown[i].origin.index), 1);
        EXPECT_EQ(crown[i].turn.azimuth, expected.azimuth);
        const double clean_elevation = kBack[crown[i].parent].elevation + clean_crown[i].turn.elevation;
        EXPECT_NEAR(kBack[crown[i].parent].elevation + crown[i].turn.elevation,
                    std::min(clean_elevation + expected.elevation, kPi / 2), 1e-15);
    }
    const Placement neck = of_kind(jittered, FillKind::kNeck).front();
    EXPECT_EQ(neck.turn.azimuth,
              offset(static_cast<std::uint32_t>(*neck.origin.parent), static_cast<std::uint32_t>(neck.origin.index), 2)
                  .azimuth);
}

TEST(Rows, JitterStaysWithinNineDegreesAndThePoles) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Rows jittered = rows({{0, 1.5}, {0.5, 1.5}, {1, 1.5}}, {50.0, 100.0, 100.0}, seed);
        for (const Placement& placement : jittered.placements) {
            const int sign = placement.origin.kind == FillKind::kNeck ? -1 : 1;
            const int copies = placement.origin.kind == FillKind::kAlong ? 0 : placement.origin.index;
            EXPECT_LE(std::abs(placement.turn.azimuth), kPi / 20);
            EXPECT_LE(std::abs(placement.turn.elevation - sign * copies * 9 * kDegree), kPi / 20 + 1e-15);
            EXPECT_LE(1.5 + placement.turn.elevation, kPi / 2 + 1e-15);
        }
    }
}

TEST(Rows, TheHairLineHoldsAfterTheJitterForEveryCopyToTheNeck) {
    test::Random random(7);
    std::size_t copies = 0, beyond = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Roots roots{{random.between(-kPi, kPi), random.between(-0.5, 1.5)},
                          {random.between(-kPi, kPi), random.between(-0.5, 1.5)}};
        const Rows jittered = rows(roots, {50.0, {}, 100.0}, seed);
        for (const Placement& copy : of_kind(jittered, FillKind::kNeck)) {
            EXPECT_TRUE(is_within_hairline(
                {roots[copy.parent].azimuth + copy.turn.azimuth, roots[copy.parent].elevation + copy.turn.elevation}));
            ++copies;
        }
        beyond += jittered.beyond_hairline;
    }
    EXPECT_GT(copies, 1000u);
    EXPECT_GT(beyond, 500u);
}

TEST(Rows, AreCountedBeyondWhatIsListed) {
    const Rows all = rows(kBack, {50.0, 100.0, 100.0});
    const Rows some = lay_rows(kBack, true, {50.0, 100.0, 100.0}, {}, 10);
    EXPECT_EQ(some.count, all.count);
    EXPECT_EQ(all.count, all.placements.size());
    EXPECT_EQ(some.placements.size(), 10u);
}

}  // namespace
}  // namespace tuftwave
