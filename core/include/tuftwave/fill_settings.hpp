#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tuftwave/limits.hpp"
#include "tuftwave/result.hpp"
#include "tuftwave/schedule.hpp"

namespace tuftwave {

/// Which way round the head a fill goes from the one tuft to the other, seen from above.
enum class FillDirection { kCounterClockwise, kClockwise, kShorter };

/// How the tufts along share the gap: each gets room by its own diameter, and so does the last tuft; by half its own
/// and half its neighbour's; or as equation (5) is printed, where the last one along lands on the second tuft.
enum class Spacing { kDiameter, kHalfGap, kAsPrinted };

/// How a gap is measured: by equation (2), or along the path that the roots go.
enum class Arc { kSpherical, kPath };

/// How many tufts a fill gives, 1 (sparse) to 100 (dense); empty or 0 is none.
struct Densities {
    std::optional<double> along = 50;  ///< m_W
    std::optional<double> crown;       ///< m_U
    std::optional<double> neck;        ///< m_D
};

/// How a gap is filled.
struct FillSettings {
    std::string name = "fill";  ///< what the new tufts' names begin with
    Densities density;
    std::optional<double> tufts_per_meter;  ///< k, at density 100; default 32 around a head of the roots' mean radius
    FillDirection direction = FillDirection::kCounterClockwise;
    std::optional<Spacing> spacing;  ///< default kDiameter, as printed kAsPrinted
    Arc arc = Arc::kSpherical;
    std::optional<bool> resample;  ///< whether unequal numbers of points are made equal; default true, as printed false
    double min_gap = 0;            ///< least distance of a copy's root from others, in diameters of the copy
    std::optional<std::uint64_t> jitter_seed;  ///< empty is no jitter
    Formulas formulas = Formulas::kCorrected;
};

/// @errors  not_finite, out_of_range
Check check_fill_settings(const FillSettings& settings, const Limits& limits);

inline bool is_on(const std::optional<double>& density) { return density && *density != 0; }

}  // namespace tuftwave
