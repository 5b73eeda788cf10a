#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tuftwave/limits.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/result.hpp"

namespace tuftwave {

/// A chain in one picture: its nodes, root first, in any unit.
using Line = std::vector<Vec3>;

/// How far a chain is from where it should be.
struct LineError {
    double angle = 0;     ///< mean unsigned angle between segments that belong together, radians
    double position = 0;  ///< mean distance of nodes that belong together, roots laid on each other, as a share of the
                          ///< chain's rest length
};

/// The same for a whole cycle.
struct MotionError {
    LineError mean;                   ///< over all pictures
    std::vector<LineError> pictures;  ///< of each picture
};

/// @param lines  the pictures of one chain
/// @errors  too_few (pictures; nodes, of which there must be 2), too_many, not_finite, out_of_range, conflict (unequal
///          numbers of nodes); below "/0" ... for each picture
Check check_lines(std::span<const Line> lines, const Limits& limits);

/// Compares a chain's pictures with those it should have.
/// @param lines, reference  checked, as many pictures with as many nodes each
/// @param rest_length       of the chain, > 0, in the lines' unit
/// @errors  conflict ("" pictures, "/0" nodes: not as many as the reference has)
/// Source: Furukawa and Nakata 2018, Table 1.
Result<MotionError> measure_error(std::span<const Line> lines, std::span<const Line> reference, double rest_length);

/// The error of holding the mean of the pictures still, without which an error says little.
/// @param reference  checked
MotionError still_error(std::span<const Line> reference, double rest_length);

/// Several chains together. Every segment and every node but the roots counts the same, in every picture.
/// @param segments  of each chain
LineError error_in_all(std::span<const MotionError> chains, std::span<const std::size_t> segments);

/// The mean over the pictures of a chain's length. @param lines  checked
double mean_length(std::span<const Line> lines);

}  // namespace tuftwave
