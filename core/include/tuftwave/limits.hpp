#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "tuftwave/result.hpp"

namespace tuftwave {

/// Corners that a ring can have; fixed, because rings are meshed on the stack.
inline constexpr int kMostSides = 64;

/// A closed range of numbers.
struct Range {
    double minimum, maximum;
};

/// Everything that is limited, in one place. Core checks it before work or memory is spent; the service publishes
/// it at /v1/limits; openapi.yaml states the same numbers and a test compares the two.
struct Limits {
    // How much may be asked for
    std::size_t tufts = 16'384;
    std::size_t points_per_tuft = 1'024;
    std::size_t points = 131'072;  ///< in all tufts
    std::size_t fills = 1'024;
    std::size_t scalp_vertices = 200'000;
    std::size_t scalp_triangles = 200'000;
    std::size_t chains = 16'384;
    std::size_t nodes_per_chain = 65;
    std::size_t joints = 65'536;       ///< in all chains; joint indices are 16 bits
    std::size_t node_poses = 327'680;  ///< nodes of all chains times pictures; as JSON 250 bytes each
    std::size_t joint_keys = 524'288;  ///< joints of all chains times the keys that a file has of each
    std::size_t drawn_nodes = 16'384;  ///< nodes of all drawings times pictures, in a fit
    std::size_t rings_per_tuft = 4'096;
    std::size_t vertices = 1'000'000;  ///< in one answer; 56 bytes each, and a third more as text
    std::size_t triangles = 2'000'000;
    std::size_t frames = 1'440;         ///< in one cycle: a minute at 24 frames per second
    std::size_t sheet_frames = 14'400;  ///< in one sheet: ten minutes
    std::size_t sheet_cells = 524'288;  ///< in one sheet: tracks times pictures of all cycles
    std::size_t pictures = 24;

    // What a value may be
    Range coordinate{-1e6, 1e6};       ///< metres
    Range root_depth{0, 10};           ///< metres
    Range diameter_at_100{1e-6, 1e3};  ///< metres
    Range scalp_radius{1e-6, 1e6};     ///< metres
    Range scalp_vertex{0, 199'999};    ///< that a triangle may name
    Range diameter{1, 100};
    Range widest_at{1, 100};  ///< percent of the arc length
    Range flatness{0, 0.98};
    Range twist_deg{-3'600, 3'600};
    Range roll_deg{-360, 360};
    Range joints_per_tuft{1, 64};
    Range origin{1, 16'386};           ///< numbers that say where a filled tuft comes from
    Range density{1, 100};             ///< of a fill, unless it is off
    Range tufts_per_meter{1e-3, 1e6};  ///< of a fill's gap, at density 100
    Range min_gap{0, 10};              ///< diameters
    Range sides{3, kMostSides};
    Range rings{2, 4'096};
    Range tolerance{1e-5, 1};  ///< metres
    Range amplitude{-100, 100};
    Range spatial_period{0.05, 100};  ///< of the magnitude
    Range lightness{0.05, 100};       ///< of the magnitude
    Range tip_exponent{0.05, 8};
    Range period{0.01, 60};  ///< seconds
    Range fps{1, 240};
    Range hold{1, 24};  ///< frames
    Range lift{0, 1};
    Range phase{-1'000, 1'000};  ///< radians
    Range cycles{1, 11};
    Range gust_wavelength{1e-3, 1e6};  ///< metres
    Range spread{0, 1};
    Range repeat{1, 1'440};  ///< cycles in a sheet
    Range fit_steps{1, 1'000};
    Range rest_length{1e-9, 1e9};  ///< of a drawn chain, in its own unit
};

/// False also for what is not a number.
inline bool is_within(double value, Range range) { return value >= range.minimum && value <= range.maximum; }

/// @errors  not_finite, out_of_range
Check check_range(double value, Range range, std::string_view field);

/// Like check_range, for the magnitude of `value`: zero and values near it are refused on both sides.
Check check_magnitude(double value, Range range, std::string_view field);

/// @errors  too_few, too_many
Check check_count(std::size_t count, std::size_t minimum, std::size_t maximum, std::string_view field);

/// For what only a sum over a request can exceed. @param what  what is counted, for the message: "points in all tufts"
/// @errors  too_many
Check check_total(std::size_t total, std::size_t most, std::string_view what, std::string_view field);

/// A number as people write it, without trailing zeros: "0.45", "24".
std::string to_text(double value);

}  // namespace tuftwave
