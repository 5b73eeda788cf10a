// Based on: Shimosoyama, Yamamoto, Noma. NPR Hair Modeling by Controlling the Shape of Tufts. Section 4.1, equations
// (5) and (6). Differs: the paper lets every step's azimuth sweep through [0, 2 pi) by itself, which turns -13 degrees
// into +347. Here a step turns along with the root, and the difference goes the short way. A step that has no azimuth
// keeps the angle to its root that the other stroke's step has; one without length also takes the other's elevation.
#include "tuftwave/fill_stroke.hpp"

#include <cmath>

#include "tuftwave/curve.hpp"
#include "tuftwave/head.hpp"

namespace tuftwave {
namespace {

/// An angle the short way round, in [-pi, pi].
double short_way(double angle) { return angle - 2 * kPi * std::round(angle / (2 * kPi)); }

}  // namespace

std::vector<Vec3> resampled(std::span<const Vec3> points, std::size_t count) {
    const Curve curve(points);
    std::vector<Vec3> even;
    even.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        even.push_back(curve.at(curve.arc_length() * static_cast<double>(i) / static_cast<double>(count - 1)).point);
    return even;
}

StrokesBetween::StrokesBetween(std::span<const Vec3> from, std::span<const Vec3> to, const Gap& gap) {
    steps_.reserve(from.size());
    const double radius = length(from[0]);
    steps_.push_back({{gap.azimuth, gap.sweep}, {gap.elevation, gap.rise}, {radius, length(to[0]) - radius}});
    for (std::size_t i = 1; i < from.size(); ++i)
        steps_.push_back(step_between(from[i] - from[i - 1], to[i] - to[i - 1], gap, to[0]));
}

StrokesBetween::Step StrokesBetween::step_between(const Vec3& from, const Vec3& to, const Gap& gap,
                                                  const Vec3& to_root) {
    Bearing a = bearing_of(from), b = bearing_of(to);
    const double to_azimuth = is_vertical(to_root) ? gap.azimuth : bearing_of(to_root).azimuth;
    const bool has_a = !is_vertical(from), has_b = !is_vertical(to);
    if (!has_a) a.azimuth = has_b ? gap.azimuth + (b.azimuth - to_azimuth) : gap.azimuth;
    if (!has_b) b.azimuth = to_azimuth + (a.azimuth - gap.azimuth);
    const double from_length = length(from), to_length = length(to);
    if (from_length == 0) a.elevation = b.elevation;
    if (to_length == 0) b.elevation = a.elevation;
    const double turn = gap.sweep + short_way(b.azimuth - a.azimuth - gap.sweep);
    return {{a.azimuth, turn}, {a.elevation, b.elevation - a.elevation}, {from_length, to_length - from_length}};
}

std::vector<Vec3> StrokesBetween::stroke(double turned, double grown) const {
    std::vector<Vec3> points;
    points.reserve(steps_.size());
    Vec3 point;
    for (const Step& step : steps_) {
        const Vec3 direction = vector_towards({step.azimuth.at(turned), step.elevation.at(turned)});
        point = point + step.length.at(grown) * direction;  // eq. (5), (6)
        points.push_back(point);
    }
    return points;
}

}  // namespace tuftwave
