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
    const Hairstyle* hairstyle = nullptr;  ///< must outlive the plan
    Limits limits;
    std::vector<MeshPlan> tufts;  ///< the drawn ones, then those of each fill
    std::vector<Chain> chains;    ///< one per tuft
    std::vector<FillReport> fills;
    std::vector<std::vector<Tuft>> filled;  ///< the tufts of each fill
    std::optional<HairMotion> motion;
    std::size_t vertices = 0, indices = 0, joints = 0;
};

/// Everything about one tuft's mesh but the vertices. Where rings are given and nothing hangs on bones, a plan keeps no
/// more than the mesh's size, since rings take memory and need only be known while their vertices are written.
/// @param made  room for what the plan did not keep
const MeshPlan& mesh_plan(const HairPlan& plan, std::size_t tuft, MeshPlan& made);

/// Plans a hairstyle: every limit is checked before a vertex is made.
/// @errors  those of check_head, check_tuft, check_detail, plan_fill, make_schedule, move_chains; too_few (tufts),
///          too_many (tufts, fills, points, joints, vertices, triangles), conflict (motion without a skin), cancelled.
///          Where several tufts are wrong the first one is named.
/// Deterministic for any `for_each`.
Result<HairPlan> plan_hairstyle(const Hairstyle& hairstyle, const Limits& limits, const ForEach& for_each,
                                std::stop_token stop);

}  // namespace tuftwave
