#pragma once

#include <cstddef>
#include <vector>

#include "tuftwave/motion.hpp"

namespace tuftwave {

/// How one chain's wave angles become turns in model space.
class Laying {
  public:
    Laying(const Chain& chain, const Motion& motion);
    /// @param whole  the chain's length, where that is known
    Laying(const Chain& chain, double whole, const Motion& motion);

    /// What all bones turn about by their wave angles, unit.
    const Vec3& axis() const { return axis_; }

    /// How bone `i` is turned away from its rest pose before that.
    const Quat& lift(std::size_t i) const { return lifts_[lifts_.size() == 1 ? 0 : i]; }

  private:
    Vec3 axis_;                // unit; a positive angle turns the hair towards up, or outward when one-sided
    std::vector<Quat> lifts_;  // from rest towards the wind: one for the whole chain, or one per bone in absolute mode
};

}  // namespace tuftwave
