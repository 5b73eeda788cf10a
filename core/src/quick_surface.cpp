// Based on: our own. The normals of ring_normals.cpp, where floats are good enough for them.
#include "quick_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "corners.hpp"

namespace tuftwave {
namespace {

/// Share of the largest area that a piece before or behind a corner could have, squared, below which floats lose its
/// direction.
constexpr float kLeastArea = 1e-6F;
/// Likewise of the sum of two unit normals: below it they look apart by more than 156 degrees.
constexpr float kLeastSum = 0.04F;
/// Squares that are smaller may have lost digits.
constexpr float kLeastSquare = 1e-30F;

/// One number per corner, as many as Corners::padded().
using Row = std::array<float, Corners::kMost>;

struct Rows {
    alignas(64) Row x, y, z;

    /// What puts them side by side.
    TUFTWAVE_BODY auto interleaved(std::size_t count) const {
        return [this, count](float* to) {
            for (std::size_t k = 0; k < count; ++k) {
                to[3 * k] = x[k];
                to[3 * k + 1] = y[k];
                to[3 * k + 2] = z[k];
            }
        };
    }
};

struct Point {
    float x, y, z;

    TUFTWAVE_BODY explicit Point(const Vec3& v)
        : x(static_cast<float>(v.x)), y(static_cast<float>(v.y)), z(static_cast<float>(v.z)) {}
};

/// From the middle of a ring to its corners, in units of the tuft's half width. The last one is there again before the
/// first, so that each has both neighbours beside it.
struct Offsets {
    alignas(64) std::array<float, Corners::kMost + 2> x{}, y{}, z{};
    Vec3 middle;
    double width = 0;

    TUFTWAVE_BODY void close(std::size_t sides, std::size_t padded) {
        for (auto* row : {&x, &y, &z}) {
            (*row)[0] = (*row)[sides];
            (*row)[padded + 1] = (*row)[padded % sides + 1];
        }
    }
};

/// From ring to ring: of the middles, and the square of what the way between two corners can be at most.
struct Way {
    Point middle;
    float most;

    TUFTWAVE_BODY Way(const Offsets& from, const Offsets& to, double scale) : Way(scale * (to.middle - from.middle)) {
        most += static_cast<float>(from.width * from.width + to.width * to.width);
    }

  private:
    TUFTWAVE_BODY explicit Way(const Vec3& way) : middle(way), most(static_cast<float>(dot(way, way))) {}
};

TUFTWAVE_BODY void stand(const Ring& ring, const Corners& corners, const float* reach, double scale, Offsets& offsets,
                         Rows& places) {
    const Point middle(ring.frame.point), up(ring.half_thickness * ring.frame.normal),
        across(ring.half_width * ring.frame.binormal());
    const auto unit = static_cast<float>(scale);
    const float *cosines = corners.short_cosines(), *sines = corners.short_sines();
    for (std::size_t k = 0; k < corners.padded(); ++k) {
        const float cosine = reach[k] * cosines[k], sine = reach[k] * sines[k];
        const float x = cosine * up.x + sine * across.x, y = cosine * up.y + sine * across.y,
                    z = cosine * up.z + sine * across.z;
        offsets.x[k + 1] = unit * x;
        offsets.y[k + 1] = unit * y;
        offsets.z[k + 1] = unit * z;
        places.x[k] = middle.x + x;
        places.y[k] = middle.y + y;
        places.z[k] = middle.z + z;
    }
    offsets.close(corners.count(), corners.padded());
    offsets.middle = ring.frame.point;
    offsets.width = scale * ring.half_width;
}

/// The sums of the normals before and after, not yet of unit length.
struct Sums {
    Rows sums;
    alignas(64) Row squares;  // of their lengths
};

/// @return  whether floats are good enough for all of them
TUFTWAVE_BODY bool find_sums(const Offsets& before, const Offsets& here, const Offsets& after, const Way& in,
                             const Way& out, std::size_t padded, Sums& found) {
    const auto area = static_cast<float>(here.width * here.width);
    const float least_in = kLeastArea * area * in.most, least_out = kLeastArea * area * out.most;
    std::uint32_t lost = 0;
    for (std::size_t k = 0; k < padded; ++k) {
        const float around_x = here.x[k + 2] - here.x[k], around_y = here.y[k + 2] - here.y[k],
                    around_z = here.z[k + 2] - here.z[k];
        const float in_x = in.middle.x + (here.x[k + 1] - before.x[k + 1]),
                    in_y = in.middle.y + (here.y[k + 1] - before.y[k + 1]),
                    in_z = in.middle.z + (here.z[k + 1] - before.z[k + 1]);
        const float out_x = out.middle.x + (after.x[k + 1] - here.x[k + 1]),
                    out_y = out.middle.y + (after.y[k + 1] - here.y[k + 1]),
                    out_z = out.middle.z + (after.z[k + 1] - here.z[k + 1]);
        const float first_x = around_y * in_z - around_z * in_y, first_y = around_z * in_x - around_x * in_z,
                    first_z = around_x * in_y - around_y * in_x;
        const float second_x = around_y * out_z - around_z * out_y, second_y = around_z * out_x - around_x * out_z,
                    second_z = around_x * out_y - around_y * out_x;
        const float first_square = first_x * first_x + first_y * first_y + first_z * first_z;
        const float second_square = second_x * second_x + second_y * second_y + second_z * second_z;
        // first / |first| + second / |second|, times |first| |second|^2.
        const float product = first_square * second_square, both = std::sqrt(product);
        const float sum_x = second_square * first_x + both * second_x,
                    sum_y = second_square * first_y + both * second_y,
                    sum_z = second_square * first_z + both * second_z;
        const float square = sum_x * sum_x + sum_y * sum_y + sum_z * sum_z;
        lost |= (first_square > least_in ? 0U : 1U) | (second_square > least_out ? 0U : 1U) |
                (square > kLeastSum * product * second_square + kLeastSquare ? 0U : 1U);
        found.sums.x[k] = sum_x;
        found.sums.y[k] = sum_y;
        found.sums.z[k] = sum_z;
        found.squares[k] = square;
    }
    return lost == 0;
}

TUFTWAVE_BODY void normalize(const Sums& found, std::size_t padded, Rows& normals) {
    for (std::size_t k = 0; k < padded; ++k) {
        const float unit = 1 / std::sqrt(found.squares[k]);
        normals.x[k] = unit * found.sums.x[k];
        normals.y[k] = unit * found.sums.y[k];
        normals.z[k] = unit * found.sums.z[k];
    }
}

/// What makes the tuft's widest ring about 1, so that products of many sizes are floats.
double scale_of(const MeshPlan& plan) {
    double widest = 0;
    for (const Ring& ring : plan.rings) widest = std::max(widest, ring.half_width);
    return widest > 0 ? 1 / widest : 0;
}

/// What of each corner's offset is kept.
struct WholeReach {
    Row ones;

    WholeReach() { ones.fill(1); }
    const float* of(const MeshPlan& plan, std::size_t ring) const {
        const std::span<const float> reach = plan.reach.of(ring);
        return reach.empty() ? ones.data() : reach.data();
    }
};

/// Rows of vertices, written root to tip: what one has too much is overwritten by the next one.
class RowWriter {
  public:
    /// @param width  numbers per vertex
    RowWriter(std::span<float> to, std::size_t width, const Corners& corners)
        : to_(to), row_(width * (corners.count() + 1)), room_(width * corners.padded()) {}

    /// @param fill  writes a row in whole vectors
    template <class Fill>
    TUFTWAVE_BODY void write(const Fill& fill) {
        if (next_ + room_ <= to_.size()) {
            fill(&to_[next_]);
        } else {
            std::array<float, 3 * Corners::kMost> last;
            fill(last.data());
            std::copy_n(last.begin(), row_, &to_[next_]);
        }
        next_ += row_;
    }

  private:
    std::span<float> to_;
    std::size_t row_, room_, next_ = 0;
};

TUFTWAVE_BODY void write_uvs(const MeshPlan& plan, const Corners& corners, std::span<float> uvs) {
    alignas(64) Row across;
    for (std::size_t k = 0; k < corners.padded(); ++k)
        across[k] = static_cast<float>(static_cast<double>(k) / static_cast<double>(corners.count()));
    RowWriter to(uvs, 2, corners);
    for (const Ring& ring : plan.rings) {
        const auto along = static_cast<float>(ring.along);
        to.write([&](float* row) {
            for (std::size_t k = 0; k < corners.padded(); ++k) {
                row[2 * k] = across[k];
                row[2 * k + 1] = along;
            }
        });
    }
}

TUFTWAVE_BODY void write_all(const MeshPlan& plan, const Corners& corners, double scale, const SurfaceSpans& out,
                             std::vector<std::size_t>& left) {
    const std::size_t count = plan.rings.size(), padded = corners.padded();
    const WholeReach reach;
    Offsets rings[3];
    Rows rows;
    RowWriter positions(out.positions, 3, corners), normals(out.normals, 3, corners);
    Sums sums[2];  // one ring's wait for the next one's: two roots one after the other take long
    const auto write_normals = [&](std::size_t ring) {
        normalize(sums[ring % 2], padded, rows);
        normals.write(rows.interleaved(padded));
    };
    Offsets *before = &rings[0], *here = &rings[1], *after = &rings[2];
    before->middle = plan.root;
    stand(plan.rings[0], corners, reach.of(plan, 0), scale, *here, rows);
    positions.write(rows.interleaved(padded));
    Way in(*before, *here, scale);
    for (std::size_t i = 0; i < count; ++i) {
        if (i + 1 < count) {
            stand(plan.rings[i + 1], corners, reach.of(plan, i + 1), scale, *after, rows);
            positions.write(rows.interleaved(padded));
        } else if (plan.flat_tip) {
            *after = *here;
        } else {
            *after = {};
            after->middle = plan.tip;
        }
        const Way on(*here, *after, scale);
        if (!find_sums(*before, *here, *after, in, on, padded, sums[i % 2])) left.push_back(i);
        if (i > 0) write_normals(i - 1);
        Offsets* const passed = before;
        before = here;
        here = after;
        after = passed;
        in = on;
    }
    write_normals(count - 1);
    write_uvs(plan, corners, out.uvs);
}

}  // namespace

std::vector<std::size_t> write_surface_quickly(const MeshPlan& plan, Vectors vectors, const SurfaceSpans& out) {
    std::vector<std::size_t> left;
    run_with<write_all>(vectors, plan, corners_of(plan.sides), scale_of(plan), out, left);
    return left;
}

}  // namespace tuftwave
