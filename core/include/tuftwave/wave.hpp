#pragma once

#include "tuftwave/limits.hpp"
#include "tuftwave/result.hpp"

namespace tuftwave {

/// The travelling wave of a hair line, equation (1). All four are unitless: the hair is pi long, so one wave looks
/// the same on every hair.
struct Wave {
    double amplitude = 0.8;       ///< a; 0 is a straight line
    double spatial_period = 1.0;  ///< k; the wavelength is 2 pi k. Above 0 the wave runs root to tip, below tip to root
    double lightness = 1.2;       ///< s, the paper's "strength of gravity": the larger, the LESS the hair droops
    double tip_exponent = 1.0;    ///< p; how much livelier the tip is than the root
};

/// @errors  not_finite, out_of_range
Check check_wave(const Wave& wave, const Limits& limits);

/// The envelope -(a/s) (x/pi)^p, which does not depend on time.
/// @param x  distance from the root, 0 to pi
double wave_envelope(const Wave& wave, double x);

/// The height f(x, t) of the hair line at phase psi = 2 pi t / T, in units where the hair is pi long.
/// @param envelope  wave_envelope(wave, x)
/// Source: Furukawa and Nakata 2018, eq. (1).
double wave_height(const Wave& wave, double envelope, double x, double psi);

}  // namespace tuftwave
