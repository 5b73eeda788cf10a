#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "tuftwave/for_each.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/result.hpp"
#include "tuftwave/schedule.hpp"
#include "tuftwave/skeleton.hpp"
#include "tuftwave/wave.hpp"
#include "tuftwave/wide.hpp"

namespace tuftwave {

/// How the wave is laid on a chain: its angles added to the rest pose, or the paper's line along the wind itself.
enum class Mode { kRelative, kAbsolute };

/// Whether the mean over the pictures is taken out of the angles: an artist's rest pose already droops.
enum class Droop { kRemove, kKeep };

/// Whether phases between chains may be any number or whole pictures.
enum class PhaseStep { kFree, kPicture };

/// How chains are put out of step. All tufts in one rhythm look like a wig.
struct Phasing {
    PhaseStep step = PhaseStep::kFree;
    std::optional<double>
        gust_wavelength;     ///< metres along the wind between roots one cycle apart: a gust passing over the head
    double spread = 0;       ///< 0..1: share of a whole cycle that phases are scattered over at random
    std::uint64_t seed = 0;  ///< for the scatter
    int cycles = 1;          ///< waves per loop
};

/// A wave, its timing, and how it is laid on the chains.
struct Motion {
    Wave wave;
    Timing timing;
    Mode mode = Mode::kRelative;
    Vec3 wind{1, 0, 0};          ///< where it blows to, any length but zero
    Vec3 up{0, 1, 0};            ///< not parallel to the wind
    std::optional<Droop> droop;  ///< default: remove in relative mode, keep in absolute mode
    bool one_sided = false;      ///< chains only swing away from the head; relative mode only
    std::optional<double>
        lift;  ///< 0..1 from the rest direction to the wind; default 0 in relative mode, 1 in absolute
    Phasing phase;
};

/// @errors  not_finite, out_of_range, degenerate (wind zero or parallel to up), conflict (one_sided in absolute mode;
///          2 cycles >= pictures)
Check check_motion(const Motion& motion, const Schedule& schedule, const Limits& limits);

/// One chain's poses: picture n, node i is at rotations[n * nodes + i].
struct ChainMotion {
    double phase = 0;             ///< radians, what the chain really runs ahead
    std::vector<Quat> rotations;  ///< local, unit; sign-continuous from picture to picture
};

/// Moves every chain: a local rotation per picture and node. Bone lengths never change; the tip keeps its rest
/// rotation.
/// @param chains  checked; with one_sided each has `outward`
/// @errors  those of check_motion, too_many (node poses), degenerate (one_sided without outward), conflict (a chain's
///          cycles), cancelled
/// Cost O(pictures * nodes). Deterministic for any `for_each` and any `vectors`.
/// Source: Furukawa and Nakata 2018, section 2, eq. (1).
Result<std::vector<ChainMotion>> move_chains(std::span<const Chain> chains, const Motion& motion,
                                             const Schedule& schedule, const Limits& limits, const ForEach& for_each,
                                             std::stop_token stop, Vectors vectors = widest_vectors());

/// Model-space node positions of one pose, by forward kinematics from the chain's rest root.
/// @param rotations  local, one per node
std::vector<Vec3> node_positions(const Chain& chain, std::span<const Quat> rotations);

/// How each node is turned away from rest, in model axes: its posed model-space rotation, after its rest one is undone.
/// It knows nothing of rest rotations, so that it holds for every tool's bones; the tip turns as the last bone does.
/// @param rotations  local, one per node and picture, as in ChainMotion
/// @return  as many, in the same order; unit, w >= 0 in the first picture and sign-continuous from there
std::vector<Quat> model_turns(const Chain& chain, std::span<const Quat> rotations);

}  // namespace tuftwave
