#pragma once

#include <span>
#include <string_view>

#include "tuftwave/limits.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/result.hpp"

namespace tuftwave {

/// Below this a vector or quaternion has no usable direction.
inline constexpr double kShortestDirection = 1e-9;

/// Directions nearer than this, in radians, count as parallel.
inline constexpr double kSmallestSine = 1e-6;

/// @errors  not_finite, out_of_range
Check check_position(const Vec3& position, const Limits& limits, std::string_view field);

/// For a list, in which it names the first that is wrong. @errors  not_finite, out_of_range
Check check_positions(std::span<const Vec3> positions, const Limits& limits, std::string_view field);

/// @errors  not_finite, out_of_range, degenerate (no length)
Check check_direction(const Vec3& direction, const Limits& limits, std::string_view field);

/// @param other  what `b` is called, for the message
/// @errors  degenerate (parallel to within 1e-6 radians)
Check check_not_parallel(const Vec3& a, const Vec3& b, std::string_view field, std::string_view other);

}  // namespace tuftwave
