#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mesh_invariants.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/tuft.hpp"

/// What must hold for the rings of any tuft, however tightly it bends.
namespace tuftwave::test {

/// A vertex of a ring. @param column  0 to sides; the last is the first again
inline Vec3 ring_vertex(const MeshPlan& plan, const Mesh& mesh, const std::size_t ring, const std::size_t column) {
    return triple(mesh.positions, 1 + ring * (static_cast<std::size_t>(plan.sides) + 1) + column);
}

/// Whether every column of the mesh runs forwards from each ring to the next, along their mean tangent or, where few
/// rings turn so far that this leads back, along the centre line: no ring is flipped over another.
inline AssertionResult runs_forwards(const MeshPlan& plan, const Mesh& mesh) {
    constexpr double kRounding = 1e-7;  // a tenth of a micrometre: what floats leave of half a metre
    for (std::size_t i = 1; i < plan.rings.size(); ++i) {
        const Vec3 step = plan.rings[i].frame.point - plan.rings[i - 1].frame.point;
        const Vec3 tangents = plan.rings[i].frame.tangent + plan.rings[i - 1].frame.tangent;
        const Vec3 forwards = dot(step, tangents) > 0 ? tangents : step;
        for (std::size_t j = 0; j < static_cast<std::size_t>(plan.sides); ++j) {
            const double advance = dot(ring_vertex(plan, mesh, i, j) - ring_vertex(plan, mesh, i - 1, j), forwards);
            if (!(advance > -kRounding * length(forwards)))
                return AssertionFailure() << "ring " << i << " of " << plan.rings.size() << ", column " << j
                                          << " runs back by " << -advance;
        }
    }
    return AssertionSuccess();
}

/// Whether no vertex stands off further than its ring is wide, and no edge along the tuft is longer than twice what the
/// advance, the turn and the change of width between its rings account for.
inline AssertionResult has_no_spikes(const MeshPlan& plan, const Mesh& mesh) {
    constexpr double kRounding = 1e-6;  // a micrometre: floats half a metre from the origin
    const auto widest = [](const Ring& ring) { return std::max(ring.half_width, ring.half_thickness); };
    for (std::size_t i = 0; i < plan.rings.size(); ++i) {
        const Ring here = plan.rings[i], before = plan.rings[i == 0 ? 0 : i - 1];
        const double turn =
            length(here.frame.tangent - before.frame.tangent) + length(here.frame.normal - before.frame.normal);
        const double longest = length(here.frame.point - before.frame.point) + widest(here) * turn +
                               std::abs(widest(here) - widest(before));
        for (std::size_t j = 0; j < static_cast<std::size_t>(plan.sides); ++j) {
            const Vec3 vertex = ring_vertex(plan, mesh, i, j);
            if (length(vertex - here.frame.point) > widest(here) + kRounding)
                return AssertionFailure() << "ring " << i << ", column " << j << " stands off";
            if (i > 0 && length(vertex - ring_vertex(plan, mesh, i - 1, j)) > 2 * longest + kRounding)
                return AssertionFailure() << "ring " << i << ", column " << j << " is at the end of a long edge";
        }
    }
    return AssertionSuccess();
}

}  // namespace tuftwave::test
