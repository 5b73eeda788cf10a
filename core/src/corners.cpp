#include "corners.hpp"

namespace tuftwave {
namespace {

using All = std::array<Corners, kMostSides + 1>;

All all_corners() {
    All all;
    for (std::size_t sides = 3; sides < all.size(); ++sides) all[sides] = Corners(static_cast<int>(sides));
    return all;
}

}  // namespace

const Corners& corners_of(int sides) {
    static const All all = all_corners();
    return all[static_cast<std::size_t>(sides)];
}

}  // namespace tuftwave
