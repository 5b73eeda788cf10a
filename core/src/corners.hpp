#pragma once

#include <array>
#include <cstddef>

#include "tuftwave/elementary.hpp"
#include "tuftwave/tuft.hpp"

namespace tuftwave {

/// Sine and cosine of each corner of a ring, counter-clockwise about the tangent.
class Corners {
  public:
    explicit Corners(int sides) : count_(static_cast<std::size_t>(sides)) {
        for (std::size_t j = 0; j < count_; ++j)
            angles_[j] = elementary::sincos(2 * kPi * static_cast<double>(j) / sides);
    }

    std::size_t count() const { return count_; }

    /// From the ring's middle to corner `j`, metres, before anything is cut back.
    Vec3 offset(const Ring& ring, std::size_t j) const {
        return (ring.half_thickness * angles_[j].cos) * ring.frame.normal +
               (ring.half_width * angles_[j].sin) * ring.frame.binormal();
    }

  private:
    std::size_t count_;
    std::array<elementary::SinCos, kMostSides> angles_;
};

}  // namespace tuftwave
