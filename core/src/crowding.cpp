#include "crowding.hpp"

#include <algorithm>
#include <cmath>

namespace tuftwave {

AcceptedRoots::Cell AcceptedRoots::cell_of(const Vec3& root) const {
    // A coordinate is at most 1e6 and a gap at least 1e-14, or nothing is ever that near: the numbers fit.
    const double size = std::max(cell_, 1e-12);
    const auto index = [size](double x) { return static_cast<std::int64_t>(std::floor(x / size)); };
    return {index(root.x), index(root.y), index(root.z)};
}

void AcceptedRoots::add(const Vec3& root) { roots_[cell_of(root)].push_back(root); }

bool AcceptedRoots::is_crowded(const Vec3& root, double gap) const {
    const Cell middle = cell_of(root);
    for (std::int64_t x = middle[0] - 1; x <= middle[0] + 1; ++x) {
        for (std::int64_t y = middle[1] - 1; y <= middle[1] + 1; ++y) {
            for (std::int64_t z = middle[2] - 1; z <= middle[2] + 1; ++z) {
                const auto at = roots_.find({x, y, z});
                if (at == roots_.end()) continue;
                for (const Vec3& other : at->second) {
                    if (length(other - root) < gap) return true;
                }
            }
        }
    }
    return false;
}

}  // namespace tuftwave
