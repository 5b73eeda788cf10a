// Based on: Shimosoyama, Yamamoto, Noma. NPR Hair Modeling by Controlling the Shape of Tufts. Section 3.1.
// Differs: the depth is clamped so that a root never passes the center.
#include "tuftwave/head.hpp"

#include "tuftwave/vector_checks.hpp"

namespace tuftwave {
Check check_head(const Head& head, const Limits& limits) {
    if (Check wrong = check_position(head.center, limits, "/center")) return wrong;
    if (Check wrong = check_direction(head.up, limits, "/up")) return wrong;
    if (Check wrong = check_direction(head.front, limits, "/front")) return wrong;
    if (Check wrong = check_not_parallel(head.front, head.up, "/front", "up")) return wrong;
    if (Check wrong = check_range(head.root_depth, limits.root_depth, "/root_depth")) return wrong;
    return check_range(head.diameter_at_100, limits.diameter_at_100, "/diameter_at_100");
}

Vec3 sunk_root(const Head& head, const Vec3& root) {
    const Vec3 inward = head.center - root;
    const double distance = length(inward);
    if (head.root_depth >= distance) return head.center;
    return root + (head.root_depth / distance) * inward;
}

}  // namespace tuftwave
