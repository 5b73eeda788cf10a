// Based on: A. Woo. Efficient shadow computations in ray tracing. 1993, and common practice: boxes halved at the median
// of the triangles' middles. A ray from the origin is tested against a triangle by the volumes that it spans with the
// edges; neighbours compute the same number for a common edge, so that no ray slips through between them.
#include "tuftwave/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tuftwave {
namespace {

constexpr std::uint32_t kTrianglesPerLeaf = 4;

/// Boxes are made larger by this share of their distance from the origin, above the rounding of the test.
constexpr double kBoxMargin = 1e-12;

/// Stands in for a zero in a direction, so that its inverse is finite.
constexpr double kTiny = 1e-200;

/// Hits nearer to each other than this share of their distance are one, on an edge or a corner.
constexpr double kSameHit = 1e-12;

constexpr std::size_t kDeepest = 64;  // halving 2^32 triangles takes 32 levels

double along_axis(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

Vec3 middle_of(const std::array<Vec3, 3>& t) { return t[0] + t[1] + t[2]; }

Vec3 lower(const Vec3& a, const Vec3& b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3 upper(const Vec3& a, const Vec3& b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

double inverse_of(double component) { return 1 / (std::abs(component) < kTiny ? kTiny : component); }

bool meets_box(const Vec3& low, const Vec3& high, const Vec3& inverse) {
    const Vec3 a{low.x * inverse.x, low.y * inverse.y, low.z * inverse.z};
    const Vec3 b{high.x * inverse.x, high.y * inverse.y, high.z * inverse.z};
    const Vec3 enter = lower(a, b), leave = upper(a, b);
    const double first = std::max({enter.x, enter.y, enter.z, 0.0});
    const double last = std::min({leave.x, leave.y, leave.z});
    return first <= last;
}

/// How far along a ray from the origin a triangle is; negative where the ray misses it.
double triangle_at(const std::array<Vec3, 3>& t, const Vec3& direction) {
    const double a = dot(direction, cross(t[1], t[2]));
    const double b = dot(direction, cross(t[2], t[0]));
    const double c = dot(direction, cross(t[0], t[1]));
    const bool is_inside = (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
    const double sum = a + b + c;
    if (!is_inside || sum == 0) return -1;
    return dot((a / sum) * t[0] + (b / sum) * t[1] + (c / sum) * t[2], direction);
}

double square_of(const Vec3& v) { return dot(v, v); }

double square_to_box(const Vec3& low, const Vec3& high, const Vec3& point) {
    const Vec3 outside = upper(upper(low - point, point - high), Vec3{});
    return square_of(outside);
}

/// @param from, to  not the same
Vec3 nearest_on_edge(const Vec3& from, const Vec3& to, const Vec3& point) {
    const Vec3 edge = to - from;
    const double part = dot(point - from, edge) / square_of(edge);
    return from + std::clamp(part, 0.0, 1.0) * edge;
}

Vec3 nearest_on(const std::array<Vec3, 3>& t, const Vec3& point) {
    const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
    const double size = square_of(normal);
    bool is_above = size > 0;
    for (std::size_t i = 0; i < 3 && is_above; ++i)
        is_above = dot(cross(t[(i + 1) % 3] - t[i], point - t[i]), normal) >= 0;
    if (is_above) return point - (dot(point - t[0], normal) / size) * normal;
    Vec3 nearest = t[0];
    for (std::size_t i = 0; i < 3; ++i) {
        if (t[i] == t[(i + 1) % 3]) continue;
        const Vec3 candidate = nearest_on_edge(t[i], t[(i + 1) % 3], point);
        if (square_of(candidate - point) < square_of(nearest - point)) nearest = candidate;
    }
    return nearest;
}

}  // namespace

TriangleTree::TriangleTree(std::vector<std::array<Vec3, 3>> triangles) : triangles_(std::move(triangles)) {
    nodes_.reserve(triangles_.size());
    build(0, static_cast<std::uint32_t>(triangles_.size()));
}

TriangleTree::Box TriangleTree::box_around(std::uint32_t first, std::uint32_t count) const {
    Box box{triangles_[first][0], triangles_[first][0]};
    for (std::uint32_t i = first; i < first + count; ++i) {
        for (const Vec3& corner : triangles_[i]) {
            box.low = lower(box.low, corner);
            box.high = upper(box.high, corner);
        }
    }
    const double margin = kBoxMargin * (length(box.low) + length(box.high));
    return {box.low - Vec3{margin, margin, margin}, box.high + Vec3{margin, margin, margin}};
}

void TriangleTree::build(std::uint32_t first, std::uint32_t count) {
    const Box box = box_around(first, count);
    const std::size_t here = nodes_.size();
    nodes_.push_back({box, first, count});
    if (count <= kTrianglesPerLeaf) return;

    const Vec3 size = box.high - box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t half = count / 2;
    const auto begin = triangles_.begin() + first;
    // The other axes break ties, so that the order is total but for triangles with the same middle.
    std::nth_element(begin, begin + half, begin + count, [axis](const auto& s, const auto& t) {
        const Vec3 a = middle_of(s), b = middle_of(t);
        for (int turn = 0; turn < 3; ++turn) {
            const double difference = along_axis(a, (axis + turn) % 3) - along_axis(b, (axis + turn) % 3);
            if (difference != 0) return difference < 0;
        }
        return false;
    });
    build(first, half);
    nodes_[here].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[here].count = 0;
    build(first + half, count - half);
}

std::vector<double> TriangleTree::hits(const Vec3& direction) const {
    const Vec3 inverse{inverse_of(direction.x), inverse_of(direction.y), inverse_of(direction.z)};
    std::vector<double> found;
    std::array<std::uint32_t, kDeepest> waiting{};
    std::size_t count = 1;
    while (count > 0) {
        const std::uint32_t index = waiting[--count];
        const Node& node = nodes_[index];
        if (!meets_box(node.box.low, node.box.high, inverse)) continue;
        if (node.count == 0) {
            waiting[count++] = index + 1;
            waiting[count++] = node.first;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const double distance = triangle_at(triangles_[i], direction);
            if (distance >= 0) found.push_back(distance);
        }
    }
    std::sort(found.begin(), found.end());
    const auto is_same = [](double a, double b) { return b - a <= kSameHit * b; };
    found.erase(std::unique(found.begin(), found.end(), is_same), found.end());
    return found;
}

Vec3 TriangleTree::nearest(const Vec3& point) const { return nearest_below(0, point, triangles_.front()[0]); }

Vec3 TriangleTree::nearest_below(std::uint32_t index, const Vec3& point, const Vec3& best) const {
    const Node& node = nodes_[index];
    if (square_to_box(node.box.low, node.box.high, point) >= square_of(best - point)) return best;
    if (node.count == 0) {
        const std::uint32_t children[] = {index + 1, node.first};
        const auto square_to = [&](std::uint32_t child) {
            return square_to_box(nodes_[child].box.low, nodes_[child].box.high, point);
        };
        const std::size_t nearer = square_to(children[1]) < square_to(children[0]) ? 1 : 0;
        const Vec3 first = nearest_below(children[nearer], point, best);
        return nearest_below(children[1 - nearer], point, first);
    }
    Vec3 nearest = best;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const Vec3 candidate = nearest_on(triangles_[i], point);
        if (square_of(candidate - point) < square_of(nearest - point)) nearest = candidate;
    }
    return nearest;
}

}  // namespace tuftwave
