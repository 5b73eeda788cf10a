#pragma once

#include <cstddef>
#include <vector>

#include "tuftwave/motion.hpp"

namespace tuftwave {

/// How one chain's wave angles become turns in model space.
class Laying {
  public:
    Laying(const Chain& chain, const Motion& motion);

    /// The turn of bone `i` away from its rest pose at wave angle `angle`, radians.
    Quat turn(std::size_t i, double angle) const;

    /// What a bone turns about, unit.
    const Vec3& axis() const { return axis_; }

  private:
    Vec3 axis_;                // unit; a positive angle turns the hair towards up, or outward when one-sided
    std::vector<Quat> lifts_;  // from rest towards the wind: one for the whole chain, or one per bone in absolute mode
};

}  // namespace tuftwave
