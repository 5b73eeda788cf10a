// Based on: our own choice. A head is no sphere: a stroke that lies well where it was drawn can cut through the skull
// where a fill turns it to, although its root is on the scalp there.
#include "tuftwave/clearance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>

#include "tuftwave/curve.hpp"

namespace tuftwave {
namespace {

/// How far above the scalp a bent stroke is lifted, as a share of the distance from the center: 0.1 mm on a head, more
/// than the line sags between two places that are looked at.
constexpr double kMargin = 1e-3;
/// Depth up to which a stroke counts as outside, likewise: 0.01 mm.
constexpr double kTolerance = 1e-4;

/// A stroke shorter than this share of the distance from the center is none: a hundredth of a millimetre on a head.
constexpr double kShortestStroke = 1e-4;

/// Most strokes that can be mended take one to four bends; one that leaves its root too flat takes up to twenty.
constexpr int kMostBends = 24;

/// A point near the deepest place moves by at most this many times the depth there.
constexpr double kMostReach = 10;

std::vector<Vec3> with_sunk_root(std::span<const Vec3> stroke, double root_depth) {
    const double radius = length(stroke[0]);
    std::vector<Vec3> points{std::max(0.0, 1 - root_depth / radius) * stroke[0]};
    points.insert(points.end(), stroke.begin(), stroke.end());
    return points;
}

/// The places at some shares of a curve, rising.
std::vector<Vec3> places_on(const Curve& curve, std::span<const int> shares) {
    std::vector<double> along;
    along.reserve(shares.size());
    for (const int share : shares) along.push_back(curve.arc_length() * share / kClearanceShares);
    std::vector<CurveFrame> frames(shares.size());
    curve.at(along, frames);
    std::vector<Vec3> places;
    places.reserve(shares.size());
    for (const CurveFrame& frame : frames) places.push_back(frame.point);
    return places;
}

/// Whether hardly anything of a stroke is left, which then has no curve.
bool is_shrunk(std::span<const Vec3> stroke) {
    double drawn = 0;
    for (std::size_t i = 1; i < stroke.size(); ++i) drawn += length(stroke[i] - stroke[i - 1]);
    return drawn < kShortestStroke * length(stroke[0]);
}

struct Deepest {
    int share = -1;
    double depth = 0;  // metres
    Vec3 place, way_out;
};

/// Also just before a wanted place: the parents may come out anywhere between the two.
bool is_wanted(const Clearance& wanted, std::size_t share) {
    return wanted[share] || (share + 1 < wanted.size() && wanted[share + 1]);
}

/// @param sunk  metres of the curve up to the root, which are below the scalp on purpose
Deepest deepest_place(const Curve& curve, double sunk, const Clearance& wanted, const Scalp& scalp) {
    Deepest deepest;
    const int root = static_cast<int>(std::ceil(sunk / curve.arc_length() * kClearanceShares));
    std::vector<int> shares;
    for (int share = root; share <= kClearanceShares; ++share) {
        if (is_wanted(wanted, static_cast<std::size_t>(share))) shares.push_back(share);
    }
    const std::vector<Vec3> places = places_on(curve, shares);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::optional<Vec3> way_out = scalp.way_out(places[i]);
        const double depth = way_out ? length(*way_out) : 0;
        if (depth > deepest.depth && depth > kTolerance * length(places[i]))
            deepest = {shares[i], depth, places[i], *way_out};
    }
    return deepest;
}

/// Shares of the polygon's length at which the points of a sunk stroke lie.
std::vector<double> shares_of(std::span<const Vec3> points) {
    std::vector<double> shares{0};
    for (std::size_t i = 1; i < points.size(); ++i) shares.push_back(shares.back() + length(points[i] - points[i - 1]));
    for (double& share : shares) share /= shares.back();
    return shares;
}

/// Moves the point nearest to the deepest place, and all behind it. @param sunk  the stroke with its sunk root
void bend_at(std::vector<Vec3>& stroke, const std::vector<Vec3>& sunk, const Deepest& deepest) {
    const std::vector<double> shares = shares_of(sunk);
    const double share = static_cast<double>(deepest.share) / kClearanceShares;
    std::size_t nearest = 2;  // the first point behind the root
    for (std::size_t i = 3; i < shares.size(); ++i) {
        if (std::abs(shares[i] - share) < std::abs(shares[nearest] - share)) nearest = i;
    }
    // Between two points of which one stays, a place moves by its share of the way.
    double follows = 1;
    if (share < shares[nearest]) {
        const double before = shares[nearest - 1];
        follows = std::max(1 / kMostReach, (share - before) / (shares[nearest] - before));
    }
    const double lifted = (deepest.depth + kMargin * length(deepest.place)) / deepest.depth;
    const Vec3 move = lifted / follows * deepest.way_out;
    for (std::size_t i = nearest - 1; i < stroke.size(); ++i) stroke[i] = stroke[i] + move;
}

}  // namespace

Clearance clearance_of(std::span<const Vec3> stroke, const Scalp& scalp, double root_depth) {
    const Curve curve(with_sunk_root(stroke, root_depth));
    std::array<int, kClearanceShares + 1> shares;
    std::iota(shares.begin(), shares.end(), 0);
    Clearance clearance;
    for (const Vec3& place : places_on(curve, shares)) clearance.push_back(!scalp.way_out(place));
    return clearance;
}

Clearance common_clearance(const Clearance& a, const Clearance& b) {
    Clearance both(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) both[i] = a[i] && b[i];
    return both;
}

Bend bend_outwards(std::vector<Vec3>& stroke, const Clearance& wanted, const Scalp& scalp, double root_depth) {
    for (int bend = 0; bend <= kMostBends; ++bend) {
        if (is_shrunk(stroke)) return Bend::kStuck;
        const std::vector<Vec3> sunk = with_sunk_root(stroke, root_depth);
        const Deepest deepest = deepest_place(Curve(sunk), length(stroke[0] - sunk[0]), wanted, scalp);
        if (deepest.share < 0) return bend == 0 ? Bend::kNone : Bend::kBent;
        bend_at(stroke, sunk, deepest);
    }
    return Bend::kStuck;
}

}  // namespace tuftwave
