// Based on: K. Furukawa, S. Nakata. Automatic Generation of the Periodic Hair Motion of 3D Characters for Anime
// Production. ICEC 2018. Equation (1), in other unknowns.
#include "wave_unknowns.hpp"

#include <algorithm>
#include <cmath>

namespace tuftwave {

double swing_of(const WaveUnknowns& unknowns) {
    return std::sqrt(unknowns[kCosine] * unknowns[kCosine] + unknowns[kSine] * unknowns[kSine]);
}

namespace {

/// The longest bone but the first, whose near end stands still whatever the wave; in units where the hair is pi long.
double longest_run(const DrawnPlane& plane) {
    double longest = 0;
    for (std::size_t i = 1; i < plane.bones(); ++i) longest = std::max(longest, plane.x[i + 1] - plane.x[i]);
    return longest;
}

}  // namespace

WaveBounds::WaveBounds(const DrawnPlane& plane, const Limits& limits)
    : wave_number_least(1 / limits.spatial_period.maximum),
      wave_number_most(std::clamp(kPi / longest_run(plane), 1.0, 1 / limits.spatial_period.minimum)),
      is_one_way(plane.pictures() < 3),
      exponent(limits.tip_exponent),
      size_most(limits.amplitude.maximum / (limits.lightness.minimum * limits.lightness.minimum)) {}

WaveUnknowns WaveBounds::clamped(WaveUnknowns unknowns) const {
    for (const Unknown linear : {kCosine, kSine, kDroop})
        unknowns[linear] = std::clamp(unknowns[linear], -size_most, size_most);
    double& q = unknowns[kWaveNumber];
    q = q < 0 && !is_one_way ? -std::clamp(-q, wave_number_least, wave_number_most)
                             : std::clamp(q, wave_number_least, wave_number_most);
    unknowns[kExponent] = std::clamp(unknowns[kExponent], exponent.minimum, exponent.maximum);
    return unknowns;
}

bool WaveBounds::is_blocked(const WaveUnknowns& unknowns, std::size_t unknown, double step) const {
    const double value = unknowns[unknown];
    if (unknown == kExponent) return (value <= exponent.minimum && step < 0) || (value >= exponent.maximum && step > 0);
    if (unknown != kWaveNumber) return false;
    const double outward = value < 0 ? -step : step, size = value < 0 ? -value : value;
    return (size <= wave_number_least && outward < 0) || (size >= wave_number_most && outward > 0);
}

Range lightness_range(double swing, const Limits& limits) {
    const double most =
        std::min(limits.lightness.maximum, swing > 0 ? limits.amplitude.maximum / swing : limits.lightness.maximum);
    return {limits.lightness.minimum, std::max(most, limits.lightness.minimum)};
}

Wave wave_of(const WaveUnknowns& unknowns, double lightness, const Limits& limits) {
    Wave wave;
    wave.amplitude = std::clamp(swing_of(unknowns) * lightness, limits.amplitude.minimum, limits.amplitude.maximum);
    wave.lightness = lightness;
    wave.spatial_period = 1 / unknowns[kWaveNumber];
    const double k = wave.spatial_period < 0 ? -wave.spatial_period : wave.spatial_period;
    // 1 / (1 / 0.05) may miss the limit by a rounding.
    wave.spatial_period = (wave.spatial_period < 0 ? -1 : 1) *
                          std::clamp(k, limits.spatial_period.minimum, limits.spatial_period.maximum);
    wave.tip_exponent = unknowns[kExponent];
    return wave;
}

}  // namespace tuftwave
