// Based on: K. Furukawa, S. Nakata, 2018, section 2.
// Differs: the paper draws a line in a plane; how that plane lies in space is our reading, see core/README.md.
#include "laying.hpp"

#include "tuftwave/vector_checks.hpp"

namespace tuftwave {
namespace {

/// `a` as a unit vector, or `otherwise` where it has no direction.
Vec3 unit_or(const Vec3& a, const Vec3& otherwise) {
    const double size = length(a);
    return size > kSmallestSine ? a / size : otherwise;
}

double length_of(const Chain& chain) {
    double whole = 0;
    for (std::size_t i = 1; i < chain.nodes.size(); ++i) whole += length(chain.nodes[i] - chain.nodes[i - 1]);
    return whole;
}

/// r: root to tip; where the chain ends at its root, to the node furthest from it.
Vec3 chain_direction(const Chain& chain, double whole) {
    const Vec3 root = chain.nodes.front(), to_tip = chain.nodes.back() - root;
    if (length(to_tip) > kSmallestSine * whole) return normalized(to_tip);
    Vec3 furthest;
    for (const Vec3& node : chain.nodes) {
        const Vec3 away = node - root;
        if (dot(away, away) > dot(furthest, furthest)) furthest = away;
    }
    return length(furthest) > 0 ? normalized(furthest) : Vec3{0, 1, 0};  // one bone whose tip lies on its root
}

Vec3 bone_direction(const Chain& chain, std::size_t bone, const Vec3& otherwise) {
    const Vec3 direction = chain.nodes[bone + 1] - chain.nodes[bone];
    const double size = length(direction);
    return size > 0 ? direction / size : otherwise;
}

}  // namespace

Laying::Laying(const Chain& chain, const Motion& motion) : Laying(chain, length_of(chain), motion) {}

Laying::Laying(const Chain& chain, double whole, const Motion& motion) {
    // w: wind, u: up made orthogonal to it, n: the axis that turns w towards u, r: the chain's own direction
    const Vec3 w = normalized(motion.wind);
    const Vec3 u = normalized(rejected(motion.up, w));
    const Vec3 n = cross(w, u);
    const Vec3 r = chain_direction(chain, whole);
    if (motion.mode == Mode::kAbsolute) {
        axis_ = n;
        for (std::size_t i = 0; i + 1 < chain.nodes.size(); ++i) {
            lifts_.push_back(shortest_turn(bone_direction(chain, i, r), w, n, motion.lift.value_or(1)));
        }
        return;
    }
    lifts_.push_back(shortest_turn(r, w, n, motion.lift.value_or(0)));
    const Vec3 lifted = rotated(lifts_.front(), r);
    axis_ = unit_or(rejected(n, lifted), normalized(cross(lifted, u)));
    if (motion.one_sided && chain.outward) axis_ = unit_or(cross(lifted, normalized(*chain.outward)), axis_);
}

}  // namespace tuftwave
