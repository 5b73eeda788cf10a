#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "tuftwave/fill.hpp"
#include "tuftwave/fill_settings.hpp"
#include "tuftwave/for_each.hpp"
#include "tuftwave/head.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/motion.hpp"
#include "tuftwave/schedule.hpp"
#include "tuftwave/tuft.hpp"

namespace tuftwave {

/// A fill between two tufts of a hairstyle.
struct HairFill {
    std::size_t from = 0;           ///< index of a drawn tuft
    std::optional<std::size_t> to;  ///< of another; empty, or the same, is a ring around the head
    FillSettings settings;
};

/// A whole head of hair: what a person drew, what is to be filled, and how it moves.
struct Hairstyle {
    Head head;
    std::vector<Tuft> tufts;
    std::vector<HairFill> fills;  ///< indices below tufts.size()
    std::optional<Motion> motion;
    MeshDetail mesh;
    Formulas formulas = Formulas::kCorrected;
};

/// The motion of a hairstyle's chains.
struct HairMotion {
    Schedule schedule;
    std::vector<ChainMotion> chains;  ///< one per tuft
};

/// A hairstyle filled, measured, cut into rings and moved: everything but the vertices.
struct HairPlan {
    std::vector<MeshPlan> tufts;  ///< the drawn ones, then those of each fill
    std::vector<Chain> chains;    ///< one per tuft
    std::vector<FillReport> fills;
    std::optional<HairMotion> motion;
    std::size_t vertices = 0, indices = 0, joints = 0;
};

/// Plans a hairstyle: every limit is checked before a vertex is made.
/// @errors  those of check_head, check_tuft, check_detail, plan_fill, make_schedule, move_chains; too_few (tufts),
///          too_many (tufts, fills, points, joints, vertices, triangles), cancelled. Where several tufts are wrong the
///          first one is named.
/// Deterministic for any `for_each`.
Result<HairPlan> plan_hairstyle(const Hairstyle& hairstyle, const Limits& limits, const ForEach& for_each,
                                std::stop_token stop);

}  // namespace tuftwave
