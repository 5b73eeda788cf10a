#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "tuftwave/math.hpp"

namespace tuftwave {

/// Roots that have been accepted, sorted into cells, to find out whether another is too near to one of them.
class AcceptedRoots {
  public:
    /// @param largest_gap  the largest that will be asked for, metres, > 0
    explicit AcceptedRoots(double largest_gap) : cell_(largest_gap) {}

    void add(const Vec3& root);

    /// Whether an accepted root is nearer than `gap`, metres.
    bool is_crowded(const Vec3& root, double gap) const;

  private:
    using Cell = std::array<std::int64_t, 3>;

    Cell cell_of(const Vec3& root) const;

    double cell_;
    std::map<Cell, std::vector<Vec3>> roots_;
};

}  // namespace tuftwave
