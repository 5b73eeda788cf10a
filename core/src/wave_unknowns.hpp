#pragma once

#include <array>
#include <cstddef>

#include "drawn_plane.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/wave.hpp"

namespace tuftwave {

/// The wave as least squares sees it:
///     f = -(x/pi)^p (C cos(q x - psi) + S sin(q x - psi) + B),
/// with C = A cos(phase), S = A sin(phase), A = a/s, B = a/s^2 and q = 1/k. For given q and p it is linear in the other
/// three, and none of the five is undefined for a wave without swing or without droop.
enum Unknown : std::size_t { kCosine, kSine, kDroop, kWaveNumber, kExponent };
using WaveUnknowns = std::array<double, 5>;

/// A = a/s, the wave's swing at the tip.
double swing_of(const WaveUnknowns& unknowns);

/// The droop B of a wave of this swing whose lightness is given.
inline double droop_of(double swing, double lightness) { return swing / lightness; }

/// Where the unknowns may lie.
struct WaveBounds {
    double wave_number_least = 0, wave_number_most = 0;  ///< of the magnitude
    bool is_one_way = false;  ///< only waves from root to tip: two pictures do not tell them from the others
    Range exponent{};
    double size_most = 0;  ///< of the magnitudes of C, S and B: those of the largest wave within the limits

    /// Waves within the limits, and not shorter than two of the longest segments: shorter ones look like longer ones.
    WaveBounds(const DrawnPlane& plane, const Limits& limits);

    /// The nearest wave inside; one that may run both ways keeps its direction.
    WaveUnknowns clamped(WaveUnknowns unknowns) const;

    /// Whether an unknown stands at a bound and would leave it going this way.
    bool is_blocked(const WaveUnknowns& unknowns, std::size_t unknown, double step) const;
};

/// Lightness values that a wave of this swing may have, of the magnitude: a and s must both be within the limits.
Range lightness_range(double swing, const Limits& limits);

/// The wave of equation (1). @param lightness  s, with its sign
Wave wave_of(const WaveUnknowns& unknowns, double lightness, const Limits& limits);

}  // namespace tuftwave
