#pragma once

#include <array>
#include <cstddef>

#include "tuftwave/elementary.hpp"
#include "tuftwave/tuft.hpp"

namespace tuftwave {

/// Sine and cosine of each corner of a ring, counter-clockwise about the tangent. Behind the last one they start again,
/// so that loops can take whole vectors.
class Corners {
  public:
    static constexpr std::size_t kVector = 16;  // floats, in the widest one
    static constexpr std::size_t kMost = (kMostSides / kVector + 1) * kVector;

    explicit Corners(int sides = 3) : count_(static_cast<std::size_t>(sides)), behind_(padded() % count_) {
        for (std::size_t j = 0; j < kMost; ++j) {
            const auto [sine, cosine] = elementary::sincos(2 * kPi * static_cast<double>(j % count_) / sides);
            sines_[j] = sine;
            cosines_[j] = cosine;
            short_sines_[j] = static_cast<float>(sine);
            short_cosines_[j] = static_cast<float>(cosine);
        }
    }

    std::size_t count() const { return count_; }
    /// How many there are in whole vectors, the first one once more behind the last among them.
    std::size_t padded() const { return (count_ / kVector + 1) * kVector; }
    /// Which corner is the one behind all of those.
    std::size_t behind() const { return behind_; }
    const double* sines() const { return sines_.data(); }
    const double* cosines() const { return cosines_.data(); }
    const float* short_sines() const { return short_sines_.data(); }
    const float* short_cosines() const { return short_cosines_.data(); }

    /// From the ring's middle to corner `j`, metres, before anything is cut back.
    Vec3 offset(const Ring& ring, std::size_t j) const {
        return (ring.half_thickness * cosines_[j]) * ring.frame.normal +
               (ring.half_width * sines_[j]) * ring.frame.binormal();
    }

  private:
    std::size_t count_, behind_;
    alignas(64) std::array<double, kMost> sines_, cosines_;
    alignas(64) std::array<float, kMost> short_sines_, short_cosines_;
};

/// Calls `act` with the corners' padded() as its template argument: loops of a known length need no remainders, and
/// what they fill stays in registers.
template <std::size_t kRow = Corners::kVector, class Act>
void with_row_of(const Corners& corners, const Act& act) {
    if constexpr (kRow < Corners::kMost) {
        if (corners.padded() > kRow) return with_row_of<kRow + Corners::kVector>(corners, act);
    }
    act.template operator()<kRow>();
}

/// Those of rings of so many corners, made once. @param sides  3 to kMostSides
const Corners& corners_of(int sides);

}  // namespace tuftwave
