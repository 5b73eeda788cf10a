#pragma once

#include <cstddef>
#include <vector>

#include "tuftwave/fill_settings.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/result.hpp"

namespace tuftwave {

/// The gap between two roots as seen from the head's center, and how many tufts go into it.
struct Gap {
    double azimuth = 0;          ///< of the first root, radians
    double elevation = 0;        ///< of the first root, radians
    double sweep = 0;            ///< alpha, signed: negative is clockwise seen from above, radians
    double rise = 0;             ///< beta: elevation of the second root less that of the first, radians
    double gamma = 0;            ///< the angle of the gap, radians
    double distance = 0;         ///< e, metres
    double tufts_per_meter = 0;  ///< k
    std::size_t along = 0;       ///< N
};

/// Measures a gap.
/// @param from, to  the two roots in the head's frame, metres, not the origin
/// @param is_ring   whether both are one tuft, and the gap is once around the head
/// @errors  too_many (more tufts along than a request may have; the number is given)
/// Source: Shimosoyama, Yamamoto and Noma, eq. (1) to (3).
Result<Gap> measure_gap(const Vec3& from, const Vec3& to, bool is_ring, const FillSettings& settings,
                        const Limits& limits);

/// Where tufts 1 .. N along stand, as a share of the way from the first root (0) to the second (1), rising.
/// @param from, to  diameters d of the two tufts
/// Source: Shimosoyama, Yamamoto and Noma, eq. (4) and (5).
std::vector<double> spread_along(std::size_t along, double from, double to, Spacing spacing);

}  // namespace tuftwave
