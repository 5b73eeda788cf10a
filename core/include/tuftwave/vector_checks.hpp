#pragma once

#include <string>

#include "tuftwave/limits.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/result.hpp"

namespace tuftwave {

/// Below this a vector or quaternion has no usable direction.
inline constexpr double kShortestDirection = 1e-9;

/// Directions nearer than this, in radians, count as parallel.
inline constexpr double kSmallestSine = 1e-6;

/// @errors  not_finite, out_of_range
Check check_position(const Vec3& position, const Limits& limits, const std::string& field);

/// @errors  not_finite, out_of_range, degenerate (no length)
Check check_direction(const Vec3& direction, const Limits& limits, const std::string& field);

/// @param other  what `b` is called, for the message
/// @errors  degenerate (parallel to within 1e-6 radians)
Check check_not_parallel(const Vec3& a, const Vec3& b, const std::string& field, const std::string& other);

}  // namespace tuftwave
