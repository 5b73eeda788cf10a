// Based on: our own. Two things animators look at: the tip draws a figure of eight, and no bone jumps.
#include "tuftwave/quality.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tuftwave/elementary.hpp"

namespace tuftwave {
namespace {

constexpr int kPathPoints = 360;  // one per degree of the cycle

/// Tangent of the angle (0.3 degrees) below which a path comes back on itself: on a hair of 25 cm the loops of such an
/// eight are less than a millimetre wide. The polygon of a path to and fro crosses itself hundreds of times below it.
constexpr double kSmallestCrossing = 0.005;

struct Point {
    double x = 0, y = 0;
};

/// The tip of a straight hair of bones of equal, fixed length, root at the origin, at phase psi.
Point tip_at(const Wave& wave, int bones, double psi) {
    Point tip;
    const auto height = [&](double x) { return wave_height(wave, wave_envelope(wave, x), x, psi); };
    for (int i = 0; i < bones; ++i) {
        const double x0 = kPi * i / bones, x1 = kPi * (i + 1) / bones;
        const auto direction = elementary::sincos(elementary::atan2(height(x1) - height(x0), x1 - x0));
        tip.x += direction.cos / bones;
        tip.y += direction.sin / bones;
    }
    return tip;
}

/// Twice the signed area of a, b, c.
double turn_of(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether two steps of the path cross, and not just run along each other.
bool cross_each_other(const Point& a, const Point& b, const Point& c, const Point& d) {
    if ((turn_of(a, b, c) > 0) == (turn_of(a, b, d) > 0) || (turn_of(c, d, a) > 0) == (turn_of(c, d, b) > 0))
        return false;
    const Point u{b.x - a.x, b.y - a.y}, v{d.x - c.x, d.y - c.y};
    return std::abs(u.x * v.y - u.y * v.x) > kSmallestCrossing * std::abs(u.x * v.x + u.y * v.y);
}

/// The angle between two rotations, radians.
double angle_between(const Quat& a, const Quat& b) {
    const Quat turn = inverse(a) * b;
    const double vector_part = std::sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
    return 2 * elementary::atan2(vector_part, std::abs(turn.w));
}

}  // namespace

int tip_crossings(const Wave& wave, int bones) {
    if (bones < 2) return 0;  // to and fro on a circle
    std::vector<Point> path;
    for (int i = 0; i < kPathPoints; ++i) path.push_back(tip_at(wave, bones, 2 * kPi * i / kPathPoints));
    const auto at = [&](std::size_t i) { return path[i % kPathPoints]; };
    int crossings = 0;
    for (std::size_t i = 0; i < kPathPoints; ++i) {
        for (std::size_t j = i + 2; j < kPathPoints && j + 1 < i + kPathPoints; ++j) {
            if (cross_each_other(at(i), at(i + 1), at(j), at(j + 1))) ++crossings;
        }
    }
    return crossings;
}

double largest_step(const Chain& chain, const ChainMotion& motion) {
    const std::size_t nodes = chain.nodes.size(), pictures = motion.rotations.size() / nodes;
    std::vector<Quat> globals(motion.rotations);
    for (std::size_t at = 0; at < globals.size(); ++at) {
        if (at % nodes != 0) globals[at] = globals[at - 1] * globals[at];
    }
    double largest = 0;
    for (std::size_t n = 0; n < pictures; ++n) {
        for (std::size_t i = 0; i + 1 < nodes; ++i) {
            largest = std::max(largest, angle_between(globals[n * nodes + i], globals[(n + 1) % pictures * nodes + i]));
        }
    }
    return largest;
}

}  // namespace tuftwave
