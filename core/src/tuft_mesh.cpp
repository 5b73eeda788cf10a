// Based on: our own. A grid of rings and columns, closed by a fan at each end. The first column is repeated as the last
// one, so that u can run from 0 to 1; normals come from the grid itself, so that taper, twist, flatness and cut-back
// bends are all in them.
#include <algorithm>
#include <array>

#include "corners.hpp"
#include "tuftwave/tuft.hpp"
#include "tuftwave/vector_checks.hpp"

namespace tuftwave {
namespace {

/// Share of a ring's area below which a piece of the grid has none.
constexpr double kLeastArea = 1e-9;

class VertexWriter {
  public:
    explicit VertexWriter(const MeshSpans& out, int joints) : out_(out), joints_(joints) {}

    void write(const Vec3& position, const Vec3& normal, double u, double v) {
        put(out_.positions, 3 * next_, {position.x, position.y, position.z});
        put(out_.normals, 3 * next_, {normal.x, normal.y, normal.z});
        out_.uvs[2 * next_] = static_cast<float>(u);
        out_.uvs[2 * next_ + 1] = static_cast<float>(v);
        write_influence(v);
        ++next_;
    }

  private:
    static void put(std::span<float> to, std::size_t at, std::array<double, 3> values) {
        for (std::size_t axis = 0; axis < 3; ++axis) to[at + axis] = static_cast<float>(values[axis]);
    }

    void write_influence(double along) {
        if (along != along_) influence_ = influence_at(along_ = along, joints_);
        const auto second = static_cast<float>(influence_.second_weight);
        const bool both = second > 0;
        const std::array<float, 4> weights{1.0F - second, second, 0, 0};
        const std::array<int, 4> bones{weights[0] > 0 ? out_.first_joint + influence_.first : 0,
                                       both ? out_.first_joint + influence_.second : 0, 0, 0};
        for (std::size_t k = 0; k < 4; ++k) {
            out_.weights[4 * next_ + k] = weights[k];
            out_.joints[4 * next_ + k] = static_cast<std::uint16_t>(bones[k]);
        }
    }

    const MeshSpans& out_;
    const int joints_;
    std::size_t next_ = 0;
    double along_ = -1;
    Influence influence_{};
};

using RingPoints = std::array<Vec3, kMostSides>;

class TuftMesher {
  public:
    TuftMesher(const MeshPlan& plan, const MeshSpans& out)
        : plan_(plan), corners_(plan.sides), writer_(out, plan.joints) {}

    void write() {
        writer_.write(plan_.root, plan_.root_direction, 0.5, 0);
        RingPoints before, here, after;
        before.fill(plan_.root);
        here = points_of(0);
        for (std::size_t i = 0; i < plan_.rings.size(); ++i) {
            if (i + 1 < plan_.rings.size()) {
                after = points_of(i + 1);
            } else if (plan_.flat_tip) {
                after = here;
            } else {
                after.fill(plan_.tip);
            }
            write_ring(plan_.rings[i], before, here, after);
            before = here;
            here = after;
        }
        if (plan_.flat_tip) write_cap(before);
        writer_.write(plan_.tip, plan_.tip_direction, 0.5, 1);
    }

  private:
    RingPoints points_of(std::size_t ring) const {
        RingPoints points;
        const Ring& at = plan_.rings[ring];
        for (std::size_t j = 0; j < corners_.count(); ++j) {
            const double reach =
                plan_.reach.empty() ? 1.0 : static_cast<double>(plan_.reach[ring * corners_.count() + j]);
            points[j] = at.frame.point + reach * corners_.offset(at, j);
        }
        return points;
    }

    void write_ring(const Ring& ring, const RingPoints& before, const RingPoints& here, const RingPoints& after) {
        const std::size_t sides = corners_.count();
        for (std::size_t column = 0; column <= sides; ++column) {
            const std::size_t j = column == sides ? 0 : column;
            const Vec3 around = here[j + 1 == sides ? 0 : j + 1] - here[j == 0 ? sides - 1 : j - 1];
            const Vec3 normal = outward(ring, j, around, {here[j] - before[j], after[j] - here[j]});
            writer_.write(here[j], normal, static_cast<double>(column) / static_cast<double>(sides), ring.along);
        }
    }

    /// The unit normal halfway between the pieces before and after, however long they are: at a sharp edge it looks
    /// away from both. Straight away from the middle where neither has an area.
    Vec3 outward(const Ring& ring, std::size_t j, const Vec3& around, const std::array<Vec3, 2>& steps) const {
        Vec3 sum;
        for (const Vec3& step : steps) {
            const Vec3 normal = cross(around, step);
            const double area = length(normal);
            if (area > kLeastArea * ring.half_width * ring.half_width && area > 0) sum = sum + normal / area;
        }
        if (const double size = length(sum); size > kSmallestSine) return sum / size;
        const Vec3 offset = corners_.offset(ring, j);
        const double distance = length(offset);
        return distance > 0 ? offset / distance : ring.frame.normal;
    }

    void write_cap(const RingPoints& points) {
        const std::size_t sides = corners_.count();
        for (std::size_t column = 0; column <= sides; ++column) {
            writer_.write(points[column == sides ? 0 : column], plan_.tip_direction,
                          static_cast<double>(column) / static_cast<double>(sides), 1);
        }
    }

    const MeshPlan& plan_;
    const Corners corners_;
    VertexWriter writer_;
};

template <class Index>
class IndexWriter {
  public:
    IndexWriter(std::span<Index> out, std::uint32_t first_vertex) : out_(out), first_(first_vertex) {}

    void triangle(std::size_t a, std::size_t b, std::size_t c) {
        for (const std::size_t vertex : {a, b, c}) out_[next_++] = static_cast<Index>(first_ + vertex);
    }

  private:
    std::span<Index> out_;
    std::uint32_t first_;
    std::size_t next_ = 0;
};

template <class Index>
void write_triangles(const MeshPlan& plan, std::span<Index> out, std::uint32_t first_vertex) {
    IndexWriter<Index> writer(out, first_vertex);
    const auto sides = static_cast<std::size_t>(plan.sides);
    const std::size_t row = sides + 1;  // vertices per ring
    const auto ring_start = [&](std::size_t ring) { return 1 + ring * row; };
    for (std::size_t j = 0; j < sides; ++j) writer.triangle(0, ring_start(0) + j + 1, ring_start(0) + j);
    for (std::size_t i = 0; i + 1 < plan.rings.size(); ++i) {
        for (std::size_t j = 0; j < sides; ++j) {
            const std::size_t a = ring_start(i) + j, b = a + 1, c = a + row, d = c + 1;
            writer.triangle(a, b, c);
            writer.triangle(b, d, c);
        }
    }
    const std::size_t last = ring_start(plan.rings.size() - (plan.flat_tip ? 0 : 1));
    const std::size_t tip = plan.vertex_count() - 1;
    for (std::size_t j = 0; j < sides; ++j) writer.triangle(last + j, last + j + 1, tip);
}

}  // namespace

std::size_t MeshPlan::vertex_count() const {
    const std::size_t row = static_cast<std::size_t>(sides) + 1;
    return 2 + (rings.size() + (flat_tip ? 1 : 0)) * row;
}

std::size_t MeshPlan::index_count() const { return 6 * static_cast<std::size_t>(sides) * rings.size(); }

void write_vertices(const MeshPlan& plan, const MeshSpans& out) { TuftMesher(plan, out).write(); }

void write_indices(const MeshPlan& plan, std::span<std::uint16_t> out, std::uint32_t first_vertex) {
    write_triangles(plan, out, first_vertex);
}

void write_indices(const MeshPlan& plan, std::span<std::uint32_t> out, std::uint32_t first_vertex) {
    write_triangles(plan, out, first_vertex);
}

Mesh to_mesh(const MeshPlan& plan) {
    const std::size_t count = plan.vertex_count();
    Mesh mesh;
    mesh.positions.resize(3 * count);
    mesh.normals.resize(3 * count);
    mesh.uvs.resize(2 * count);
    mesh.joints.resize(4 * count);
    mesh.weights.resize(4 * count);
    mesh.indices.resize(plan.index_count());
    write_vertices(plan, {mesh.positions, mesh.normals, mesh.uvs, mesh.joints, mesh.weights, 0});
    write_indices(plan, std::span<std::uint32_t>(mesh.indices));
    return mesh;
}

}  // namespace tuftwave
