#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tuftwave/fill_gap.hpp"
#include "tuftwave/math.hpp"

namespace tuftwave {

/// A stroke with as many points as another, evenly along its smooth line.
/// @param points  at least 2, not all the same, metres
/// @param count   >= 2
std::vector<Vec3> resampled(std::span<const Vec3> points, std::size_t count);

/// The strokes between two strokes.
class StrokesBetween {
  public:
    /// @param from, to  in the head's frame, metres, root first; as many points each, at least 2
    /// @param gap  between their roots
    StrokesBetween(std::span<const Vec3> from, std::span<const Vec3> to, const Gap& gap);

    /// The stroke at a share of the way, without jitter and not yet on a scalp.
    /// @param turned  share of the turn, from spread_along
    /// @param grown   share of the lengths: l / (N + 1)
    /// Source: Shimosoyama, Yamamoto and Noma, eq. (5) and (6).
    std::vector<Vec3> stroke(double turned, double grown) const;

  private:
    /// From a value at the first stroke to one at the second.
    struct Change {
        double start, difference;

        double at(double share) const { return start + share * difference; }
    };
    /// A step from one point to the next, or from the head's center to the root.
    struct Step {
        Change azimuth, elevation, length;
    };

    static Step step_between(const Vec3& from, const Vec3& to, const Gap& gap, const Vec3& to_root);

    std::vector<Step> steps_;
};

}  // namespace tuftwave
