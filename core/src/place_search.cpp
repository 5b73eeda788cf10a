// Based on: E. Halley's and P. Chebyshev's methods of the third order for roots.
#include "place_search.hpp"

#include <algorithm>
#include <iterator>

#include "bezier.hpp"

namespace tuftwave {
namespace {

/// A step of the third order from further away than this share of the piece leaves more than 1e-14 of it.
constexpr double kFurthest = 2e-5;

constexpr std::size_t kVector = 4;  // doubles

TUFTWAVE_BODY bezier::Velocity velocity_of(const PlaceSearch& s, std::size_t k) {
    return {s.constant[k], s.linear[k], s.quadratic[k]};
}

/// By Hermite's cubic through both ends of the piece, where the speed is known.
TUFTWAVE_BODY void guess(PlaceSearch& s, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
        const double step = s.t1[k] - s.t0[k];
        const double share = s.wanted[k] / s.whole[k], usual_speed = s.whole[k] / step;
        const double x = share < kArcTolerance ? 0 : (share > 1 - kArcTolerance ? 1 : share), rest = 1 - x;
        const double at_start = usual_speed / s.speed0[k], at_end = usual_speed / s.speed1[k];
        const double cubic = x * x * (3 - 2 * x) + at_start * x * rest * rest - at_end * x * x * rest;
        const double bounded = cubic < 1 ? cubic : x;
        s.t[k] = s.t0[k] + (cubic > 0 ? bounded : x) * step;
    }
}

/// One of Chebyshev's steps.
TUFTWAVE_BODY void approach(PlaceSearch& s, std::size_t first, std::size_t end) {
    for (std::size_t k = first; k < end; ++k) {
        const bezier::Velocity curve = velocity_of(s, k);
        const double t = s.t[k], step = s.t1[k] - s.t0[k];
        const Vec3 velocity = curve.at(t);
        const double square = dot(velocity, velocity), speed = std::sqrt(square);
        const Vec3 bend = curve.change_at(t);
        const double beyond = curve.arc(s.t0[k], t) - s.wanted[k];
        const double part = beyond / speed;
        const double next = t - part * (1 + 0.5 * part * dot(velocity, bend) / square);
        const double above = next > s.t0[k] ? next : s.t0[k];
        const double inside = above < s.t1[k] ? above : s.t1[k];
        s.t[k] = std::abs(beyond) <= kArcTolerance * s.whole[k] ? t : inside;  // a sample's own place stays its own
        s.missed[k] = std::abs(part) <= kFurthest * step ? 0.0 : 1.0;
    }
}

TUFTWAVE_BODY void frames(PlaceSearch& s, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
        const CurveFrame from{s.point[k], s.tangent[k], s.normal[k]};
        const bezier::Velocity curve = velocity_of(s, k);
        const Vec3 point = s.start[k] + curve.way_to(s.t[k]);
        const Vec3 velocity = curve.at(s.t[k]);
        const double speed = length(velocity);
        const Vec3 tangent = bezier::chosen(speed > 0, 1 / speed * velocity, from.tangent);
        const Vec3 normal = bezier::carried_normal(from, point, tangent);
        const double size = length(normal);
        s.point.set(k, point);
        s.tangent.set(k, tangent);
        s.normal.set(k, 1 / size * normal);
        s.normal_size[k] = size > bezier::kLeastNormal ? size : 0.0;
    }
}

}  // namespace

void PlaceSearch::find_parameters(std::size_t count, Vectors vectors) {
    run_with<guess>(vectors, *this, count);
    run_with<approach>(vectors, *this, std::size_t{0}, count);
    const auto begin = missed.begin(), end = begin + static_cast<std::ptrdiff_t>(count);
    const auto first = std::find(begin, end, 1.0);
    if (first == end) return;
    // From there to the last one that missed, in whole vectors where it can be.
    const auto last = std::find(std::make_reverse_iterator(end), std::make_reverse_iterator(first), 1.0).base();
    const auto from = static_cast<std::size_t>(first - begin) / kVector * kVector;
    const auto to = (static_cast<std::size_t>(last - begin) + kVector - 1) / kVector * kVector;
    run_with<approach>(vectors, *this, from, std::min(to, count));
}

void PlaceSearch::find_frames(std::size_t count, Vectors vectors) { run_with<frames>(vectors, *this, count); }

void PlaceSearch::copy_frames(std::size_t count, const FrameRows& to) const {
    double* row = to.first;
    for (const Rows* const vectors : {&point, &tangent, &normal}) {
        for (const Row* const axis : {&vectors->x, &vectors->y, &vectors->z}) {
            std::copy_n(axis->begin(), count, row);
            row += to.stride;
        }
    }
}

}  // namespace tuftwave
