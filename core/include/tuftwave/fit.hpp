#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "tuftwave/for_each.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/measure.hpp"
#include "tuftwave/motion.hpp"
#include "tuftwave/result.hpp"
#include "tuftwave/schedule.hpp"
#include "tuftwave/wave.hpp"

namespace tuftwave {

/// A chain as somebody drew it: its nodes in every picture of one cycle, in any unit.
struct Drawing {
    std::string name;
    std::vector<Line> pictures;
    std::optional<Line> rest;  ///< the pose that the motion is added to, and the lengths of its segments; without it
                               ///< the pose about which the pictures swing evenly, and the mean of the drawn lengths
};

/// How the waves lie in the drawings, and how long to look for them.
struct FitSettings {
    Mode mode = Mode::kRelative;  ///< relative: droop removed; absolute: the drawn line lies along the wind, droop kept
    Vec3 wind{1, 0, 0};           ///< any length but zero
    Vec3 up{0, 1, 0};             ///< not parallel to the wind
    std::optional<int> cycles;    ///< waves per loop; without it, 1, or 2 or 3 where that comes much nearer
    int steps = 1'000;            ///< most refinements per drawing; counted, not timed, so that the answer is the same
                                  ///< on every machine
};

/// What a caller should know about a fit.
enum class FitWarning {
    kTwoPictures,           ///< the wave may as well travel the other way: k and -k fit equally
    kDroopNotIdentifiable,  ///< a and s cannot be told apart, only a / s is known
    kStill,                 ///< the pictures do not differ: k, p and the phase mean nothing
    kNoBetterThanStill,     ///< holding the mean pose still is as near to the drawing as the wave is
};

/// The wave that comes nearest to a drawing.
struct Fit {
    Wave wave;
    double phase = 0;          ///< radians in [-pi, pi]: what the chain runs ahead
    int cycles = 1;            ///< waves per loop
    Line rest;                 ///< nodes of the chain that, moved by this wave and phase, gives the fitted lines
    MotionError error;         ///< of the fitted lines
    MotionError still;         ///< of holding the drawn pictures' mean still
    int steps = 0;             ///< refinements that it took
    bool is_complete = false;  ///< whether the search ended by itself; otherwise this is the best so far
    std::vector<FitWarning> warnings;
};

/// @errors  too_few (pictures, of which there must be 2; nodes, of which there must be 3), too_many, not_finite,
///          out_of_range, conflict (unequal numbers of nodes), degenerate (a line without length); too_many (nodes
///          times pictures) at ""; otherwise below "/0" ... for each drawing
Check check_drawings(std::span<const Drawing> drawings, const Limits& limits);

/// Fits one wave to each drawing, by the least squares of its nodes' distances.
/// @param drawings  checked
/// @param schedule  says at which phases the pictures were drawn; null: evenly over the cycle
/// @errors  out_of_range, not_finite, degenerate below "/wind", "/up", "/cycles", "/steps"; conflict at "/cycles" (too
///          few pictures for so many) and below "/drawn" (not as many pictures as the schedule has)
/// Cost O(steps * pictures * nodes) for each drawing. Once `stop` is set, each fit is the best so far. Deterministic
/// for any `for_each`.
/// Source: Furukawa and Nakata 2018, eq. (1), read backwards.
Result<std::vector<Fit>> fit_waves(std::span<const Drawing> drawings, const FitSettings& settings,
                                   const Schedule* schedule, const Limits& limits, const ForEach& for_each,
                                   std::stop_token stop);

}  // namespace tuftwave
