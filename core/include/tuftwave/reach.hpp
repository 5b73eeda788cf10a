#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tuftwave {

/// How much of each corner's distance from the centre line is kept, so that the surface does not fold over itself.
struct Reach {
    std::size_t first_ring = 0;  ///< before it, and behind the last one there are shares of, all of it is kept
    std::size_t row = 0;         ///< shares per ring: one per corner, and the first ones once more
    std::vector<float> shares;   ///< 0 to 1, ring by ring

    /// The shares of a ring's corners; nothing where all of it is kept.
    std::span<const float> of(std::size_t ring) const {
        const std::size_t at = (ring - first_ring) * row;
        return ring < first_ring || at >= shares.size() ? std::span<const float>() : std::span(shares).subspan(at, row);
    }

    friend bool operator==(const Reach&, const Reach&) = default;
};

}  // namespace tuftwave
