#pragma once

#include <cstddef>
#include <vector>

#include "tuftwave/fit.hpp"

namespace tuftwave {

/// A point of the plane in which a chain swings, in units of the chain's rest length.
struct PlanePoint {
    double along = 0, across = 0;
};

/// A drawing as its wave sees it: each bone an arm of fixed length that turns in the plane across the chain's axis.
/// What lies along the axis no wave can change.
struct DrawnPlane {
    /// @param cycles  waves per loop
    DrawnPlane(const Drawing& drawing, const FitSettings& settings, const Schedule& schedule, int cycles);

    std::size_t bones() const { return arms.size(); }
    std::size_t pictures() const { return phases.size(); }

    Line rest;                      ///< nodes of the chain that the motion is laid on
    double rest_length = 0;         ///< its length, in the drawing's unit
    bool is_centered = false;       ///< whether each bone's mean angle over the pictures is taken out
    std::vector<double> x;          ///< of the nodes, 0 to pi
    std::vector<PlanePoint> arms;   ///< of the bones at angle zero
    std::vector<double> phases;     ///< of the pictures, radians
    std::vector<PlanePoint> nodes;  ///< as drawn, from the root: picture n, node i + 1 at [n * bones + i]
};

/// The mean over the pictures of each segment's length.
std::vector<double> segment_lengths(const std::vector<Line>& pictures);

}  // namespace tuftwave
