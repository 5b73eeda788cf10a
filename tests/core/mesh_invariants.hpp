#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tuftwave/math.hpp"
#include "tuftwave/tuft.hpp"

/// What must hold for the mesh of any tuft. Each check names the first index that is wrong.
namespace tuftwave::test {

using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

inline Vec3 triple(const std::vector<float>& values, const std::size_t index) {
    return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

inline AssertionResult is_finite_mesh(const Mesh& mesh) {
    const std::pair<const char*, const std::vector<float>*> lists[] = {
        {"positions", &mesh.positions}, {"normals", &mesh.normals}, {"uvs", &mesh.uvs}, {"weights", &mesh.weights}};
    for (const auto& [name, values] : lists) {
        for (std::size_t i = 0; i < values->size(); ++i) {
            if (!std::isfinite((*values)[i])) return AssertionFailure() << name << "[" << i << "] is " << (*values)[i];
        }
    }
    return AssertionSuccess();
}

inline double volume(const Mesh& mesh) {
    const Vec3 from = triple(mesh.positions, 0);
    double six = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3 a = triple(mesh.positions, mesh.indices[i]) - from,
                   b = triple(mesh.positions, mesh.indices[i + 1]) - from;
        six += dot(a, cross(b, triple(mesh.positions, mesh.indices[i + 2]) - from));
    }
    return six / 6;
}

inline AssertionResult has_unit_normals(const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.normals.size() / 3; ++i) {
        const double size = length(triple(mesh.normals, i));
        if (std::abs(size - 1) > 1e-6) return AssertionFailure() << "normal " << i << " is " << size << " long";
    }
    return AssertionSuccess();
}

/// Whether the normals at a triangle's corners look to the side from which it is counter-clockwise. An apex is the
/// point of a spike: its normal need only agree with the sum of the triangles around it.
inline AssertionResult has_outward_normals(const Mesh& mesh) {
    const std::size_t tip = mesh.positions.size() / 3 - 1;
    Vec3 around_root, around_tip;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3 a = triple(mesh.positions, mesh.indices[i]), b = triple(mesh.positions, mesh.indices[i + 1]);
        const Vec3 face = cross(b - a, triple(mesh.positions, mesh.indices[i + 2]) - a);
        for (std::size_t corner = i; corner < i + 3; ++corner) {
            const std::size_t vertex = mesh.indices[corner];
            if (vertex == 0) {
                around_root = around_root + face;
            } else if (vertex == tip) {
                around_tip = around_tip + face;
            } else if (dot(face, triple(mesh.normals, vertex)) < -1e-3 * length(face)) {
                return AssertionFailure() << "triangle " << i / 3 << " is turned away from its normal " << vertex;
            }
        }
    }
    if (dot(around_root, triple(mesh.normals, 0)) <= 0) return AssertionFailure() << "the root's normal looks inwards";
    if (dot(around_tip, triple(mesh.normals, tip)) <= 0) return AssertionFailure() << "the tip's normal looks inwards";
    return AssertionSuccess();
}

/// The share of the surface whose triangles look away from a normal at one of their corners, apexes left out.
inline double share_turned_away(const Mesh& mesh) {
    const std::size_t tip = mesh.positions.size() / 3 - 1;
    double whole = 0, away = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3 a = triple(mesh.positions, mesh.indices[i]), b = triple(mesh.positions, mesh.indices[i + 1]);
        const Vec3 face = cross(b - a, triple(mesh.positions, mesh.indices[i + 2]) - a);
        whole += length(face);
        const bool turned = std::any_of(&mesh.indices[i], &mesh.indices[i] + 3, [&](const std::uint32_t vertex) {
            return vertex != 0 && vertex != tip && dot(face, triple(mesh.normals, vertex)) < 0;
        });
        away += turned ? length(face) : 0;
    }
    return away / whole;
}

inline AssertionResult has_sound_weights(const Mesh& mesh, const int joints) {
    for (std::size_t i = 0; i < mesh.weights.size(); i += 4) {
        const float* weights = &mesh.weights[i];
        const std::uint16_t* bones = &mesh.joints[i];
        const bool two_at_most = weights[2] == 0 && weights[3] == 0 && bones[2] == 0 && bones[3] == 0;
        const bool positive = weights[0] >= 0 && weights[1] >= 0;
        const bool in_range = bones[0] < joints && bones[1] < joints && (weights[1] > 0 || bones[1] == 0);
        if (!two_at_most || !positive || !in_range || std::abs(weights[0] + weights[1] - 1) > 1e-6F)
            return AssertionFailure() << "vertex " << i / 4 << ": bones " << bones[0] << ", " << bones[1]
                                      << ", weights " << weights[0] << ", " << weights[1];
    }
    return AssertionSuccess();
}

}  // namespace tuftwave::test
