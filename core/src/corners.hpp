#pragma once

#include <array>
#include <cstddef>

#include "tuftwave/elementary.hpp"
#include "tuftwave/tuft.hpp"

namespace tuftwave {

/// Sine and cosine of each corner of a ring, counter-clockwise about the tangent. Behind the last one they start again,
/// kMostSides in all, so that loops can take whole vectors.
class Corners {
  public:
    explicit Corners(int sides = 3) : count_(static_cast<std::size_t>(sides)) {
        for (std::size_t j = 0; j < kMostSides; ++j) {
            const auto [sine, cosine] = elementary::sincos(2 * kPi * static_cast<double>(j % count_) / sides);
            sines_[j] = sine;
            cosines_[j] = cosine;
        }
    }

    std::size_t count() const { return count_; }
    std::size_t padded() const { return (count_ + 7) / 8 * 8; }
    const double* sines() const { return sines_.data(); }
    const double* cosines() const { return cosines_.data(); }

    /// From the ring's middle to corner `j`, metres, before anything is cut back.
    Vec3 offset(const Ring& ring, std::size_t j) const {
        return (ring.half_thickness * cosines_[j]) * ring.frame.normal +
               (ring.half_width * sines_[j]) * ring.frame.binormal();
    }

  private:
    std::size_t count_;
    alignas(64) std::array<double, kMostSides> sines_, cosines_;
};

/// Those of rings of so many corners, made once. @param sides  3 to kMostSides
const Corners& corners_of(int sides);

}  // namespace tuftwave
