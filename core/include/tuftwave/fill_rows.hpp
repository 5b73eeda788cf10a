#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tuftwave/fill_settings.hpp"
#include "tuftwave/head.hpp"
#include "tuftwave/tuft.hpp"

namespace tuftwave {

/// One tuft of a fill: which one it is, and how its parent is turned about the head's center to become it.
struct Placement {
    Origin origin;
    std::size_t parent = 0;  ///< index of the root that is copied; a tuft along is its own parent
    Bearing turn;            ///< radians; jitter, and for copies the way from the parent
};

/// The tufts of a fill, along first, then to the crown, then to the neck.
struct Rows {
    std::vector<Placement> placements;
    std::size_t count = 0;            ///< how many there are, also where they are too many to be listed
    std::size_t beyond_hairline = 0;  ///< copies to the neck that do not grow
};

/// Lists the tufts of a fill.
/// @param roots  directions of all parents in the paper's order: the first tuft, those along, the second tuft
/// @param is_to_copied  whether the last root has copies; on a ring it is the first one again
/// @param most  more than these are counted but not listed
/// Cost O(roots). Deterministic; the random numbers depend on seed, parent and copy only.
/// Source: Shimosoyama, Yamamoto and Noma, sections 4.2 and 4.3, eq. (7) and (8).
Rows lay_rows(std::span<const Bearing> roots, bool is_to_copied, const Densities& density,
              std::optional<std::uint64_t> jitter_seed, std::size_t most);

}  // namespace tuftwave
