#pragma once

#include <stop_token>

#include "drawn_plane.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/wave.hpp"

namespace tuftwave {

/// How long a search may go on. Steps are counted and not timed, so that the same drawing ends at the same wave on
/// every machine; the stop token is for whoever throws the answer away.
struct SearchBudget {
    int allowed = 0, taken = 0;  ///< steps of refinement
    std::stop_token stop;

    bool is_spent() const { return taken >= allowed || stop.stop_requested(); }
};

/// The wave that a search ended at.
struct FoundWave {
    Wave wave;
    double phase = 0;             ///< radians in [-pi, pi]
    double cost = 0;              ///< sum of the squares of the nodes' distances, in rest lengths
    bool is_droop_known = false;  ///< whether a and s can be told apart
    bool is_complete = false;     ///< whether the search ended by itself
};

/// Finds the wave that comes nearest to a drawing. @param budget  takes note of the steps
FoundWave find_wave(const DrawnPlane& plane, SearchBudget& budget, const Limits& limits);

}  // namespace tuftwave
