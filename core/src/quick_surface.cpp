// Based on: our own. The normals of surface.cpp, where floats are good enough for them.
#include "quick_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "corners.hpp"

namespace tuftwave {
namespace {

/// Share of the largest area that a piece of the grid could have, squared, below which floats lose its direction.
constexpr float kLeastArea = 1e-6F;
/// Likewise of the sum of two unit normals: below it they look apart by more than 156 degrees.
constexpr float kLeastSum = 0.04F;

using Row = std::array<float, kMostSides>;

/// From the middle of a ring to its corners, in units of the tuft's size. As in RingCorners the last one is there again
/// before the first; behind the last they start again.
struct Offsets {
    alignas(64) std::array<float, kMostSides + 2> x{}, y{}, z{};
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
    float x, y, z, most;

    TUFTWAVE_BODY Way(const Offsets& from, const Offsets& to, double scale) {
        const Vec3 way = scale * (to.middle - from.middle);
        x = static_cast<float>(way.x);
        y = static_cast<float>(way.y);
        z = static_cast<float>(way.z);
        most = static_cast<float>(dot(way, way) + from.width * from.width + to.width * to.width);
    }
};

TUFTWAVE_BODY void stand(const Ring& ring, const Corners& corners, const float* reach, double scale, Offsets& offsets,
                         Row& x, Row& y, Row& z) {
    const Vec3 middle = ring.frame.point, normal = ring.frame.normal, binormal = ring.frame.binormal();
    const double thickness = ring.half_thickness, width = ring.half_width;
    const double *cosines = corners.cosines(), *sines = corners.sines();
    for (std::size_t k = 0; k < corners.padded(); ++k) {
        const double up = thickness * cosines[k], across = width * sines[k], share = static_cast<double>(reach[k]);
        const Vec3 offset = share * (up * normal + across * binormal);
        offsets.x[k + 1] = static_cast<float>(scale * offset.x);
        offsets.y[k + 1] = static_cast<float>(scale * offset.y);
        offsets.z[k + 1] = static_cast<float>(scale * offset.z);
        x[k] = static_cast<float>(middle.x + offset.x);
        y[k] = static_cast<float>(middle.y + offset.y);
        z[k] = static_cast<float>(middle.z + offset.z);
    }
    offsets.close(corners.count(), corners.padded());
    offsets.middle = middle;
    offsets.width = scale * width;
}

/// @return  whether floats are good enough for all of them
TUFTWAVE_BODY bool find_normals(const Offsets& before, const Offsets& here, const Offsets& after, const Way& in,
                                const Way& out, std::size_t padded, Row& x, Row& y, Row& z) {
    const auto width = static_cast<float>(here.width);
    const float least_in = kLeastArea * width * width * in.most, least_out = kLeastArea * width * width * out.most;
    std::uint32_t lost = 0;
    for (std::size_t k = 0; k < padded; ++k) {
        const float around_x = here.x[k + 2] - here.x[k], around_y = here.y[k + 2] - here.y[k],
                    around_z = here.z[k + 2] - here.z[k];
        const float in_x = in.x + (here.x[k + 1] - before.x[k + 1]), in_y = in.y + (here.y[k + 1] - before.y[k + 1]),
                    in_z = in.z + (here.z[k + 1] - before.z[k + 1]);
        const float out_x = out.x + (after.x[k + 1] - here.x[k + 1]), out_y = out.y + (after.y[k + 1] - here.y[k + 1]),
                    out_z = out.z + (after.z[k + 1] - here.z[k + 1]);
        const float first_x = around_y * in_z - around_z * in_y, first_y = around_z * in_x - around_x * in_z,
                    first_z = around_x * in_y - around_y * in_x;
        const float second_x = around_y * out_z - around_z * out_y, second_y = around_z * out_x - around_x * out_z,
                    second_z = around_x * out_y - around_y * out_x;
        const float first_square = first_x * first_x + first_y * first_y + first_z * first_z;
        const float second_square = second_x * second_x + second_y * second_y + second_z * second_z;
        // first / |first| + second / |second|, times |first| |second|^2.
        const float product = first_square * second_square, both = std::sqrt(product);
        const float sum_x = second_square * first_x + both * second_x, sum_y = second_square * first_y + both * second_y,
                    sum_z = second_square * first_z + both * second_z;
        const float square = sum_x * sum_x + sum_y * sum_y + sum_z * sum_z;
        lost |= (first_square > least_in ? 0U : 1U) | (second_square > least_out ? 0U : 1U) |
                (square > kLeastSum * product * second_square ? 0U : 1U);
        const float unit = 1 / std::sqrt(square);
        x[k] = unit * sum_x;
        y[k] = unit * sum_y;
        z[k] = unit * sum_z;
    }
    return lost == 0;
}

/// Puts the three side by side, and the first corner once more at the end.
TUFTWAVE_BODY void interleave(const Row& x, const Row& y, const Row& z, std::size_t sides, float* to) {
    for (std::size_t j = 0; j < sides; ++j) {
        to[3 * j] = x[j];
        to[3 * j + 1] = y[j];
        to[3 * j + 2] = z[j];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) to[3 * sides + axis] = to[axis];
}

/// What makes the tuft's largest step or ring about 1, so that products of many sizes are floats; 0 where it has none.
double scale_of(const MeshPlan& plan) {
    double largest = 0;
    Vec3 last = plan.root;
    for (const Ring& ring : plan.rings) {
        const Vec3 way = ring.frame.point - last;
        largest = std::max({largest, ring.half_width, std::abs(way.x), std::abs(way.y), std::abs(way.z)});
        last = ring.frame.point;
    }
    return largest > 0 ? 1 / largest : 0;
}

/// How much of each corner's offset is kept, as many as Corners::padded().
class Reach {
  public:
    explicit Reach(const MeshPlan& plan) : reach_(plan.reach), sides_(static_cast<std::size_t>(plan.sides)) {
        row_.fill(1);
    }

    TUFTWAVE_BODY const float* operator()(std::size_t ring, std::size_t padded) {
        if (reach_.empty()) return row_.data();
        std::copy_n(&reach_[ring * sides_], sides_, row_.begin());
        for (std::size_t k = sides_; k < padded; ++k) row_[k] = row_[k - sides_];
        return row_.data();
    }

  private:
    std::span<const float> reach_;
    std::size_t sides_;
    Row row_;
};

TUFTWAVE_BODY void write_all(const MeshPlan& plan, const Corners& corners, double scale, float* positions,
                             float* normals, std::vector<std::size_t>& left) {
    const std::size_t count = plan.rings.size(), row = 3 * (corners.count() + 1);
    Reach reach(plan);
    Offsets rings[3];
    alignas(64) Row x, y, z;
    const auto put = [&](std::size_t ring, Offsets& offsets) {
        stand(plan.rings[ring], corners, reach(ring, corners.padded()), scale, offsets, x, y, z);
        interleave(x, y, z, corners.count(), positions + ring * row);
    };
    Offsets *before = &rings[0], *here = &rings[1], *after = &rings[2];
    before->middle = plan.root;
    put(0, *here);
    Way in(*before, *here, scale);
    for (std::size_t i = 0; i < count; ++i) {
        if (i + 1 < count) {
            put(i + 1, *after);
        } else if (plan.flat_tip) {
            *after = *here;
        } else {
            *after = {};
            after->middle = plan.tip;
        }
        const Way out(*here, *after, scale);
        if (!find_normals(*before, *here, *after, in, out, corners.padded(), x, y, z)) left.push_back(i);
        interleave(x, y, z, corners.count(), normals + i * row);
        Offsets* const passed = before;
        before = here;
        here = after;
        after = passed;
        in = out;
    }
}

}  // namespace

std::vector<std::size_t> write_surface_quickly(const MeshPlan& plan, Vectors vectors, std::span<float> positions,
                                               std::span<float> normals) {
    std::vector<std::size_t> left;
    run_with<write_all>(vectors, plan, corners_of(plan.sides), scale_of(plan), positions.data(), normals.data(), left);
    return left;
}

}  // namespace tuftwave
