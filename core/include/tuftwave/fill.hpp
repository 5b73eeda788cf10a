#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "tuftwave/fill_gap.hpp"
#include "tuftwave/fill_rows.hpp"
#include "tuftwave/fill_settings.hpp"
#include "tuftwave/fill_stroke.hpp"
#include "tuftwave/for_each.hpp"
#include "tuftwave/head.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/result.hpp"
#include "tuftwave/scalp.hpp"
#include "tuftwave/tuft.hpp"

namespace tuftwave {

/// A fill worked out, before any stroke is made: what will come, and where.
struct FillPlan {
    Gap gap;
    std::vector<double> shares;  ///< of the way, for the tufts along
    Rows rows;
    std::array<std::vector<Vec3>, 2> strokes;  ///< of the two tufts in the head's frame, with equal numbers of points
    std::array<Tuft, 2> tufts;                 ///< the shapes of the two, without points
    std::array<bool, 2> is_resampled{};
    FillSettings settings;

    std::size_t tuft_count() const { return rows.placements.size(); }
    std::size_t points_per_tuft() const { return strokes[0].size(); }
};

/// Works out a fill between two tufts.
/// @param to    null for a ring around the head
/// @param head  checked
/// @errors  those of check_tuft below "/from" and "/to", of check_fill_settings, of measure_gap; too_many (all tufts,
///          with their number; points), conflict or undefined_as_printed ("/to/points": unequal numbers of points that
///          are not to be resampled)
/// Cost O(tufts).
Result<FillPlan> plan_fill(const Tuft& from, const Tuft* to, const FillSettings& settings, const Head& head,
                           const Limits& limits);

/// What became of a fill.
struct FillReport {
    Gap gap;
    std::size_t along = 0, crown = 0, neck = 0;  ///< tufts that came
    std::size_t beyond_hairline = 0;             ///< copies to the neck that do not grow
    std::size_t crowded = 0;                     ///< copies dropped for min_gap
    std::size_t off_scalp = 0;                   ///< tufts where a scalp mesh has no surface
    std::size_t inside = 0;                      ///< tufts dropped since they would run through the head
    std::size_t moved_out = 0;                   ///< tufts bent or turned outwards to stay out of the scalp
    std::array<bool, 2> is_resampled{};          ///< the first and the second stroke

    std::size_t tuft_count() const { return along + crown + neck; }
};

struct Filled {
    std::vector<Tuft> tufts;  ///< along, crown, neck; each parent by parent
    FillReport report;
};

/// Makes the tufts of a fill.
/// @param scalp  of the same head; null is none
/// @errors  cancelled; out_of_range ("/from/points": a stroke that leaves the range of coordinates as it is turned)
/// Cost O(tufts * points), with a scalp times log triangles. Deterministic for any `for_each`.
/// Source: Shimosoyama, Yamamoto and Noma, section 4.
Result<Filled> make_fill(const FillPlan& plan, const Head& head, const Scalp* scalp, const Limits& limits,
                         const ForEach& for_each, std::stop_token stop);

}  // namespace tuftwave
