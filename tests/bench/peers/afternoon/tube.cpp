#include <algorithm>
#include <cmath>

#include "hair.hpp"

namespace afternoon {
namespace {

constexpr float kPi = 3.14159265F;

/// Catmull-Rom through the points. @param t  0 to 1 over all of them
glm::vec3 curve(const Points& points, float t) {
    const int pieces = static_cast<int>(points.size()) - 1;
    const int piece = std::min(static_cast<int>(t * static_cast<float>(pieces)), pieces - 1);
    const float u = t * static_cast<float>(pieces) - static_cast<float>(piece);
    const auto at = [&](int i) { return points[static_cast<std::size_t>(std::clamp(i, 0, pieces))]; };
    const glm::vec3 a = at(piece - 1), b = at(piece), c = at(piece + 1), d = at(piece + 2);
    return 0.5F * (2.0F * b + (c - a) * u + (2.0F * a - 5.0F * b + 4.0F * c - d) * (u * u) +
                   (3.0F * b - a - 3.0F * c + d) * (u * u * u));
}

}  // namespace

void add_tube(Mesh& mesh, const Points& points) {
    std::vector<glm::vec3> centers;
    for (int i = 0; i < kRings; ++i) centers.push_back(curve(points, static_cast<float>(i) / (kRings - 1)));
    const auto first = static_cast<unsigned>(mesh.positions.size());
    glm::vec3 normal(0, 0, 1);
    for (int i = 0; i < kRings; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const glm::vec3 before = centers[i == 0 ? 0 : at - 1], after = centers[i == kRings - 1 ? at : at + 1];
        const glm::vec3 tangent = glm::normalize(after - before);
        normal = glm::normalize(normal - tangent * glm::dot(normal, tangent));
        const glm::vec3 binormal = glm::cross(tangent, normal);
        const float along = static_cast<float>(i) / (kRings - 1);
        const float radius = kWidest * std::sin(kPi * along);
        for (int j = 0; j <= kSides; ++j) {
            const float angle = 2 * kPi * static_cast<float>(j) / kSides;
            const glm::vec3 out = std::cos(angle) * normal + std::sin(angle) * binormal;
            mesh.positions.push_back(centers[at] + radius * out);
            mesh.normals.push_back(out);
            mesh.uvs.emplace_back(static_cast<float>(j) / kSides, along);
        }
    }
    for (unsigned i = 0; i + 1 < kRings; ++i) {
        for (unsigned j = 0; j < kSides; ++j) {
            const unsigned a = first + i * (kSides + 1) + j, b = a + kSides + 1;
            for (const unsigned corner : {a, b, a + 1, a + 1, b, b + 1}) mesh.indices.push_back(corner);
        }
    }
}

}  // namespace afternoon
