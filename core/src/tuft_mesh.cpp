// Based on: our own. A grid of rings and columns, closed by a fan at each end. The first column is repeated as the last
// one, so that u can run from 0 to 1.
#include <algorithm>
#include <array>

#include "corners.hpp"
#include "fetch_ahead.hpp"
#include "quick_surface.hpp"
#include "ring_normals.hpp"
#include "tuftwave/tuft.hpp"
#include "tuftwave/wide.hpp"

namespace tuftwave {
namespace {

class TuftMesher {
  public:
    TuftMesher(const MeshPlan& plan, const MeshSpans& out, Vectors vectors)
        : plan_(plan), out_(out), vectors_(vectors), corners_(corners_of(plan.sides)) {}

    void write() {
        write_apex(plan_.root, plan_.root_direction, 0);
        const std::size_t count = plan_.rings.size() * (corners_.count() + 1);
        const SurfaceSpans rings{out_.positions.subspan(3 * next_, 3 * count),
                                 out_.normals.subspan(3 * next_, 3 * count), out_.uvs.subspan(2 * next_, 2 * count)};
        for (const std::size_t ring : write_surface_quickly(plan_, vectors_, rings))
            write_left_normals(ring, rings.normals);
        for (const double along : plan_.rings.along()) finish_row(along);
        if (plan_.flat_tip) write_cap();
        write_apex(plan_.tip, plan_.tip_direction, 1);
    }

  private:
    /// @param ring  below 0 and behind the last: what the surface ends in
    RingCorners corners_at(std::ptrdiff_t ring) const {
        const auto last = static_cast<std::ptrdiff_t>(plan_.rings.size()) - 1;
        if (ring < 0) return gathered(plan_.root);
        if (ring > last && !plan_.flat_tip) return gathered(plan_.tip);
        const auto at = static_cast<std::size_t>(std::min(ring, last));
        return standing(plan_.rings[at], corners_, plan_.reach.of(at));
    }

    void write_left_normals(std::size_t ring, std::span<float> normals) const {
        const auto at = static_cast<std::ptrdiff_t>(ring);
        const std::size_t row = 3 * (corners_.count() + 1);
        write_normals(plan_.rings[ring], corners_, {corners_at(at - 1), corners_at(at), corners_at(at + 1)},
                      normals.subspan(ring * row, row));
    }

    static void put(std::span<float> to, const Vec3& v) {
        to[0] = static_cast<float>(v.x);
        to[1] = static_cast<float>(v.y);
        to[2] = static_cast<float>(v.z);
    }

    void write_apex(const Vec3& place, const Vec3& direction, double along) {
        put(out_.positions.subspan(3 * next_), place);
        put(out_.normals.subspan(3 * next_), direction);
        out_.uvs[2 * next_] = 0.5F;
        out_.uvs[2 * next_ + 1] = static_cast<float>(along);
        write_influences(along, 1);
        ++next_;
    }

    /// The last ring once more, looking the way that the tip does.
    void write_cap() {
        const std::size_t columns = corners_.count() + 1;
        const auto copy_last = [&](std::span<float> all, std::size_t width) {
            const auto row = all.subspan(width * (next_ - columns), 2 * width * columns);
            std::copy_n(row.begin(), width * columns, row.begin() + static_cast<std::ptrdiff_t>(width * columns));
        };
        copy_last(out_.positions, 3);
        copy_last(out_.uvs, 2);
        for (std::size_t vertex = next_; vertex < next_ + columns; ++vertex) {
            put(out_.normals.subspan(3 * vertex), plan_.tip_direction);
            out_.uvs[2 * vertex + 1] = 1;
        }
        finish_row(1);
    }

    /// What hangs a row on the bones.
    void finish_row(double along) {
        write_influences(along, corners_.count() + 1);
        next_ += corners_.count() + 1;
    }

    void write_influences(double along, std::size_t count) {
        if (out_.weights.empty()) return;
        const Influence influence = influence_at(along, plan_.joints);
        const auto second = static_cast<float>(influence.second_weight);
        const std::array<float, 4> weights{1.0F - second, second, 0, 0};
        const auto bone = [&](float weight, int index) {
            return static_cast<std::uint16_t>(weight > 0 ? out_.first_joint + index : 0);
        };
        const std::array<std::uint16_t, 4> bones{bone(weights[0], influence.first), bone(second, influence.second), 0,
                                                 0};
        for (std::size_t vertex = next_; vertex < next_ + count; ++vertex) {
            for (std::size_t k = 0; k < 4; ++k) {
                out_.weights[4 * vertex + k] = weights[k];
                out_.joints[4 * vertex + k] = bones[k];
            }
        }
    }

    const MeshPlan& plan_;
    const MeshSpans& out_;
    const Vectors vectors_;
    const Corners& corners_;
    std::size_t next_ = 0;  // vertex
};

/// Writes the two triangles between each two columns of a row and those of the next, row by row.
template <class Index>
TUFTWAVE_BODY void write_rows(Index* out, std::size_t rows, std::size_t sides, std::size_t first) {
    std::array<Index, 6 * kMostSides> pattern;
    const std::size_t row = sides + 1;  // vertices per ring
    for (std::size_t j = 0; j < sides; ++j) {
        const std::size_t a = j, b = a + 1, c = a + row, d = c + 1;
        const std::array<std::size_t, 6> corners{a, b, c, b, d, c};
        for (std::size_t k = 0; k < 6; ++k) pattern[6 * j + k] = static_cast<Index>(corners[k]);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const auto start = static_cast<Index>(first + i * row);
        fetch_ahead(out, 6 * sides * sizeof(Index));
        for (std::size_t k = 0; k < 6 * sides; ++k) out[k] = static_cast<Index>(pattern[k] + start);
        out += 6 * sides;
    }
}

template <class Index>
void write_triangles(const MeshPlan& plan, std::span<Index> out, std::uint32_t first_vertex) {
    Index* next = out.data();
    const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
        for (const std::size_t vertex : {a, b, c}) *next++ = static_cast<Index>(first_vertex + vertex);
    };
    const auto sides = static_cast<std::size_t>(plan.sides);
    const auto ring_start = [&](std::size_t ring) { return 1 + ring * (sides + 1); };
    const std::size_t rings = plan.ring_count;
    for (std::size_t j = 0; j < sides; ++j) triangle(0, ring_start(0) + j + 1, ring_start(0) + j);
    run_with<write_rows<Index>>(widest_vectors(), next, rings - 1, sides, first_vertex + ring_start(0));
    next += 6 * sides * (rings - 1);
    const std::size_t last = ring_start(rings - (plan.flat_tip ? 0 : 1));
    const std::size_t tip = plan.vertex_count() - 1;
    for (std::size_t j = 0; j < sides; ++j) triangle(last + j, last + j + 1, tip);
}

}  // namespace

std::size_t MeshPlan::vertex_count() const {
    const std::size_t row = static_cast<std::size_t>(sides) + 1;
    return 2 + (ring_count + (flat_tip ? 1 : 0)) * row;
}

std::size_t MeshPlan::index_count() const { return 6 * static_cast<std::size_t>(sides) * ring_count; }

void write_vertices(const MeshPlan& plan, const MeshSpans& out, Vectors vectors) {
    TuftMesher(plan, out, vectors).write();
}

void write_indices(const MeshPlan& plan, std::span<std::uint16_t> out, std::uint32_t first_vertex) {
    write_triangles(plan, out, first_vertex);
}

void write_indices(const MeshPlan& plan, std::span<std::uint32_t> out, std::uint32_t first_vertex) {
    write_triangles(plan, out, first_vertex);
}

Mesh to_mesh(const MeshPlan& plan, Vectors vectors) {
    const std::size_t count = plan.vertex_count();
    Mesh mesh;
    mesh.positions.resize(3 * count);
    mesh.normals.resize(3 * count);
    mesh.uvs.resize(2 * count);
    mesh.joints.resize(4 * count);
    mesh.weights.resize(4 * count);
    mesh.indices.resize(plan.index_count());
    write_vertices(plan, {mesh.positions, mesh.normals, mesh.uvs, mesh.joints, mesh.weights, 0}, vectors);
    write_indices(plan, std::span<std::uint32_t>(mesh.indices));
    return mesh;
}

}  // namespace tuftwave
