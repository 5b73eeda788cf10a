#include "tuftwave/scalp_shape.hpp"

#include <string>

#include "tuftwave/vector_checks.hpp"

namespace tuftwave {
namespace {

Check check_ellipsoid(const ScalpEllipsoid& ellipsoid, const Limits& limits) {
    if (ellipsoid.center) {
        if (Check wrong = check_position(*ellipsoid.center, limits, "/ellipsoid/center")) return wrong;
    }
    const double radii[] = {ellipsoid.radii.x, ellipsoid.radii.y, ellipsoid.radii.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (Check wrong = check_range(radii[axis], limits.scalp_radius, "/ellipsoid/radii/" + std::to_string(axis)))
            return wrong;
    }
    return {};
}

/// The lists are flat in a request, so that is how their elements are named.
Check check_mesh(const ScalpMesh& mesh, const Limits& limits) {
    if (Check wrong = check_count(mesh.positions.size(), 3, limits.scalp_vertices, "/mesh/positions")) return wrong;
    if (Check wrong = check_count(mesh.triangles.size(), 1, limits.scalp_triangles, "/mesh/triangles")) return wrong;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const double coordinates[] = {mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (is_within(coordinates[axis], limits.coordinate)) continue;
            return check_range(coordinates[axis], limits.coordinate, "/mesh/positions/" + std::to_string(3 * i + axis));
        }
    }
    const Range vertices{0, static_cast<double>(mesh.positions.size() - 1)};
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            if (mesh.triangles[i][corner] < mesh.positions.size()) continue;
            return check_range(mesh.triangles[i][corner], vertices,
                               "/mesh/triangles/" + std::to_string(3 * i + corner));
        }
    }
    return {};
}

}  // namespace

Check check_scalp_shape(const ScalpShape& shape, const Limits& limits) {
    if (const auto* ellipsoid = std::get_if<ScalpEllipsoid>(&shape)) return check_ellipsoid(*ellipsoid, limits);
    if (const auto* mesh = std::get_if<ScalpMesh>(&shape)) return check_mesh(*mesh, limits);
    return {};
}

}  // namespace tuftwave
