// Based on: K. Furukawa, S. Nakata. Automatic Generation of the Periodic Hair Motion of 3D Characters for Anime
// Production. ICEC 2018. Equation (1).
#include "tuftwave/wave.hpp"

#include "tuftwave/elementary.hpp"
#include "tuftwave/math.hpp"

namespace tuftwave {

Check check_wave(const Wave& wave, const Limits& limits) {
    if (Check wrong = check_range(wave.amplitude, limits.amplitude, "/amplitude")) return wrong;
    if (Check wrong = check_magnitude(wave.spatial_period, limits.spatial_period, "/spatial_period")) return wrong;
    if (Check wrong = check_magnitude(wave.lightness, limits.lightness, "/lightness")) return wrong;
    return check_range(wave.tip_exponent, limits.tip_exponent, "/tip_exponent");
}

double wave_envelope(const Wave& wave, double x) {
    // a: amplitude, s: lightness, p: tip exponent
    const double a = wave.amplitude, s = wave.lightness, p = wave.tip_exponent;
    return -(a / s) * elementary::pow(x / kPi, p);
}

double wave_height(const Wave& wave, double envelope, double x, double psi) {
    const double k = wave.spatial_period, s = wave.lightness;
    return envelope * (elementary::cos(x / k - psi) + 1 / s);  // eq. (1)
}

}  // namespace tuftwave
