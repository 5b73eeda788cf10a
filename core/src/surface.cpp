// Based on: our own. Normals come from the grid itself, so that taper, twist, flatness and cut-back bends are all in
// them.
#include "surface.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include "tuftwave/vector_checks.hpp"

namespace tuftwave {
namespace {

/// Share of a ring's area below which a piece of the grid has none.
constexpr double kLeastArea = 1e-9;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

using Row = std::array<double, kMostSides>;

TUFTWAVE_BODY void stand_around(RingCorners& to, const Ring& ring, const Corners& corners,
                                std::span<const float> reach) {
    const std::size_t sides = corners.count();
    const Vec3 middle = ring.frame.point, normal = ring.frame.normal, binormal = ring.frame.binormal();
    for (std::size_t j = 0; j < sides; ++j) {
        const double up = ring.half_thickness * corners.cosines()[j], across = ring.half_width * corners.sines()[j];
        const Vec3 offset = up * normal + across * binormal;
        to.x[j + 1] = middle.x + offset.x;
        to.y[j + 1] = middle.y + offset.y;
        to.z[j + 1] = middle.z + offset.z;
    }
    for (std::size_t j = 0; j < sides && !reach.empty(); ++j) {
        if (reach[j] == 1) continue;
        const Vec3 corner = middle + static_cast<double>(reach[j]) * corners.offset(ring, j);
        to.x[j + 1] = corner.x;
        to.y[j + 1] = corner.y;
        to.z[j + 1] = corner.z;
    }
    for (auto* row : {&to.x, &to.y, &to.z}) {
        (*row)[0] = (*row)[sides];
        (*row)[sides + 1] = (*row)[1];
    }
}

/// The directions halfway between the two pieces at each corner, as unit vectors.
/// @param lost  whether one of them is none, and not finite
TUFTWAVE_BODY void find_normals(const RingNeighbours& rings, std::size_t sides, double least_area, Row& x, Row& y,
                                Row& z, bool& lost) {
    const auto& [before, here, after] = rings;
    std::uint64_t none = 0;
    for (std::size_t j = 0; j < sides; ++j) {
        const Vec3 at{here.x[j + 1], here.y[j + 1], here.z[j + 1]};
        const Vec3 around{here.x[j + 2] - here.x[j], here.y[j + 2] - here.y[j], here.z[j + 2] - here.z[j]};
        const Vec3 in{at.x - before.x[j + 1], at.y - before.y[j + 1], at.z - before.z[j + 1]};
        const Vec3 out{after.x[j + 1] - at.x, after.y[j + 1] - at.y, after.z[j + 1] - at.z};
        const Vec3 first = cross(around, in), second = cross(around, out);
        const double first_area = length(first), second_area = length(second);
        // first / first_area + second / second_area, times both areas: without divisions, or selections within
        // selections. One without an area counts nothing.
        const double has_first = first_area > least_area ? 1 : 0, has_second = second_area > least_area ? 1 : 0;
        const double first_scale = has_first * first_area + (1 - has_first);
        const double second_scale = has_second * second_area + (1 - has_second);
        const Vec3 sum = has_first * second_scale * first + has_second * first_scale * second;
        const double size = length(sum);
        const bool is_known = size > kSmallestSine * first_scale * second_scale;
        none |= is_known ? 0U : 1U;
        const double unit = is_known ? 1 / size : kNone;
        x[j] = sum.x * unit;
        y[j] = sum.y * unit;
        z[j] = sum.z * unit;
    }
    lost = none != 0;
}

/// Rounds and interleaves, and repeats the first. @param x, y, z  from the first corner on
TUFTWAVE_BODY void interleave(const double* x, const double* y, const double* z, std::size_t sides, float* to) {
    for (std::size_t j = 0; j < sides; ++j) {
        to[3 * j] = static_cast<float>(x[j]);
        to[3 * j + 1] = static_cast<float>(y[j]);
        to[3 * j + 2] = static_cast<float>(z[j]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) to[3 * sides + axis] = to[axis];
}

/// Straight away from the middle, where a normal is not finite.
void mend(const Ring& ring, const Corners& corners, Row& x, Row& y, Row& z) {
    for (std::size_t j = 0; j < corners.count(); ++j) {
        if (std::isfinite(x[j])) continue;
        const Vec3 offset = corners.offset(ring, j);
        const double distance = length(offset);
        const Vec3 normal = distance > 0 ? offset / distance : ring.frame.normal;
        x[j] = normal.x;
        y[j] = normal.y;
        z[j] = normal.z;
    }
}

TUFTWAVE_BODY void write_ring(const Ring& ring, const Corners& corners, const RingNeighbours& rings, float* positions,
                              float* normals) {
    const std::size_t sides = corners.count();
    alignas(64) Row x, y, z;
    bool lost = false;
    find_normals(rings, sides, kLeastArea * ring.half_width * ring.half_width, x, y, z, lost);
    if (lost) mend(ring, corners, x, y, z);
    interleave(rings.here.x.data() + 1, rings.here.y.data() + 1, rings.here.z.data() + 1, sides, positions);
    interleave(x.data(), y.data(), z.data(), sides, normals);
}

}  // namespace

void RingCorners::gather(const Vec3& place) {
    x.fill(place.x);
    y.fill(place.y);
    z.fill(place.z);
}

void RingCorners::stand(const Ring& ring, const Corners& corners, std::span<const float> reach, Vectors vectors) {
    run_with<stand_around>(vectors, *this, ring, corners, reach);
}

void write_corners(const Ring& ring, const Corners& corners, const RingNeighbours& rings, Vectors vectors,
                   std::span<float> positions, std::span<float> normals) {
    run_with<write_ring>(vectors, ring, corners, rings, positions.data(), normals.data());
}

}  // namespace tuftwave
