#include "tuftwave/scalp.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tuftwave {
namespace {

Vec3 divided(const Vec3& a, const Vec3& b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }

/// How far it is from a point in a unit sphere to its surface, in lengths of `direction`.
double distance_out(const Vec3& from, const Vec3& direction) {
    const double a = dot(direction, direction), b = dot(direction, from), rest = dot(from, from) - 1;
    return (std::sqrt(b * b - a * rest) - b) / a;
}

}  // namespace

std::optional<Scalp> Scalp::of(const Head& head) {
    const HeadFrame frame(head);
    if (const auto* shape = std::get_if<ScalpEllipsoid>(&head.scalp)) {
        // The paper's frame has depth second and height third.
        return Scalp(Ellipsoid{frame.to_head(shape->center.value_or(head.center)),
                               {shape->radii.x, shape->radii.z, shape->radii.y}});
    }
    if (const auto* shape = std::get_if<ScalpMesh>(&head.scalp)) {
        std::vector<Vec3> positions;
        positions.reserve(shape->positions.size());
        for (const Vec3& position : shape->positions) positions.push_back(frame.to_head(position));
        std::vector<std::array<Vec3, 3>> triangles;
        triangles.reserve(shape->triangles.size());
        for (const auto& [a, b, c] : shape->triangles) triangles.push_back({positions[a], positions[b], positions[c]});
        return Scalp(TriangleTree(std::move(triangles)));
    }
    return {};
}

std::optional<double> Scalp::distance_towards(const Vec3& direction) const {
    if (const auto* tree = std::get_if<TriangleTree>(&surface_)) {
        const std::vector<double> hits = tree->hits(direction);
        if (hits.empty()) return {};
        return hits.back();
    }
    const auto& [center, radii] = std::get<Ellipsoid>(surface_);
    return distance_out(divided(Vec3{} - center, radii), divided(direction, radii));
}

std::optional<Vec3> Scalp::way_out(const Vec3& point) const {
    return std::visit([&](const auto& surface) { return way_out_of(surface, point); }, surface_);
}

std::optional<Vec3> Scalp::way_out_of(const Ellipsoid& ellipsoid, const Vec3& point) {
    const Vec3 from = divided(point - ellipsoid.center, ellipsoid.radii);
    if (dot(from, from) > 1) return {};
    // Along the normal of the ellipsoid of the same shape through the point; from the middle, up.
    const Vec3 normal = divided(from, ellipsoid.radii);
    const Vec3 direction = length(normal) > 0 ? normalized(normal) : Vec3{0, 0, 1};
    return distance_out(from, divided(direction, ellipsoid.radii)) * direction;
}

std::optional<Vec3> Scalp::way_out_of(const TriangleTree& tree, const Vec3& point) {
    const double radius = length(point);
    const std::vector<double> hits = tree.hits(radius > 0 ? point / radius : Vec3{0, 0, 1});
    const auto further_out = hits.end() - std::lower_bound(hits.begin(), hits.end(), radius);
    // Each surface further out leads from inside to outside or back: an odd number is left where one is inside.
    if (further_out % 2 == 0) return {};
    return tree.nearest(point) - point;
}

}  // namespace tuftwave
