// Based on: our own. The normals of ring_normals.cpp, where floats are good enough for them.
#include "quick_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "corners.hpp"
#include "fetch_ahead.hpp"

namespace tuftwave {
namespace {

/// Share of the largest area that a piece before or behind a corner could have, squared, below which floats lose its
/// direction.
constexpr float kLeastArea = 1e-6F;
/// Likewise of the sum of two unit normals: below it they look apart by more than 156 degrees.
constexpr float kLeastSum = 0.04F;
/// Squares that are smaller may have lost digits.
constexpr float kLeastSquare = 1e-30F;

struct Point {
    float x, y, z;

    TUFTWAVE_BODY explicit Point(const Vec3& v)
        : x(static_cast<float>(v.x)), y(static_cast<float>(v.y)), z(static_cast<float>(v.z)) {}
};

/// What makes the tuft's widest ring about 1, so that products of many sizes are floats.
double scale_of(const MeshPlan& plan) {
    double widest = 0;
    for (const double half_width : plan.rings.half_widths()) widest = std::max(widest, half_width);
    return widest > 0 ? 1 / widest : 0;
}

/// Rows of vertices, written root to tip: what one has too much is overwritten by the next one.
/// @tparam kRoom  numbers that are written of each row
template <std::size_t kRoom>
class RowWriter {
  public:
    /// @param row  numbers that are kept
    RowWriter(std::span<float> to, std::size_t row) : to_(to), row_(row) {}

    /// @param fill  writes a row
    template <class Fill>
    TUFTWAVE_BODY void write(const Fill& fill) {
        if (next_ + kRoom <= to_.size()) {
            fetch_ahead(&to_[next_], kRoom * sizeof(float));
            fill(&to_[next_]);
        } else {
            std::array<float, kRoom> last;
            fill(last.data());
            std::copy_n(last.begin(), row_, &to_[next_]);
        }
        next_ += row_;
    }

  private:
    std::span<float> to_;
    std::size_t row_, next_ = 0;
};

/// A tuft's surface, ring by ring.
/// @tparam kRow  Corners::padded()
template <std::size_t kRow>
class Surface {
  public:
    TUFTWAVE_BODY static void write(const MeshPlan& plan, double scale, const SurfaceSpans& out,
                                    std::vector<std::size_t>& left) {
        Surface(plan, scale, out).write_rings(out, left);
    }

  private:
    using Row = std::array<float, kRow>;

    struct Rows {
        alignas(64) Row x, y, z;

        /// What puts them side by side.
        TUFTWAVE_BODY auto interleaved() const {
            return [this](float* to) {
                for (std::size_t k = 0; k < kRow; ++k) {
                    to[3 * k] = x[k];
                    to[3 * k + 1] = y[k];
                    to[3 * k + 2] = z[k];
                }
            };
        }
    };

    /// From the middle of a ring to its corners, in units of the tuft's half width. The last one is there again before
    /// the first, so that each has both neighbours beside it.
    struct Offsets {
        static constexpr std::size_t kFirst = Corners::kVector;  // so that the corners are aligned
        using LongRow = std::array<float, kFirst + kRow + 1>;
        alignas(64) LongRow x{}, y{}, z{};
        Vec3 middle;
        double width = 0;

        TUFTWAVE_BODY void close(const Corners& corners) {
            for (LongRow* const row : {&x, &y, &z}) {
                (*row)[kFirst - 1] = (*row)[kFirst + corners.count() - 1];
                (*row)[kFirst + kRow] = (*row)[kFirst + corners.behind()];
            }
        }
    };

    /// From the corners of a ring to those of the next.
    struct Ways {
        Rows ways;
        float most;  // the square of their length

        TUFTWAVE_BODY void find(const Offsets& from, const Offsets& to, double scale) {
            const Vec3 way = scale * (to.middle - from.middle);
            const Point middle(way);
            most =
                static_cast<float>(dot(way, way)) + static_cast<float>(from.width * from.width + to.width * to.width);
            for (std::size_t k = 0; k < kRow; ++k) {
                const std::size_t at = Offsets::kFirst + k;
                ways.x[k] = middle.x + (to.x[at] - from.x[at]);
                ways.y[k] = middle.y + (to.y[at] - from.y[at]);
                ways.z[k] = middle.z + (to.z[at] - from.z[at]);
            }
        }
    };

    /// The sums of the normals before and after, not yet of unit length.
    struct Sums {
        Rows sums;
        alignas(64) Row squares;                                // of their lengths
        alignas(64) std::array<std::uint32_t, kRow> were_lost;  // 1 where floats are not good enough

        TUFTWAVE_BODY void find(const Offsets& here, const Ways& in, const Ways& out) {
            const auto area = static_cast<float>(here.width * here.width);
            const float least_in = kLeastArea * area * in.most, least_out = kLeastArea * area * out.most;
            for (std::size_t k = 0; k < kRow; ++k) {
                const std::size_t at = Offsets::kFirst + k;
                const float around_x = here.x[at + 1] - here.x[at - 1], around_y = here.y[at + 1] - here.y[at - 1],
                            around_z = here.z[at + 1] - here.z[at - 1];
                const float in_x = in.ways.x[k], in_y = in.ways.y[k], in_z = in.ways.z[k];
                const float out_x = out.ways.x[k], out_y = out.ways.y[k], out_z = out.ways.z[k];
                const float first_x = around_y * in_z - around_z * in_y, first_y = around_z * in_x - around_x * in_z,
                            first_z = around_x * in_y - around_y * in_x;
                const float second_x = around_y * out_z - around_z * out_y,
                            second_y = around_z * out_x - around_x * out_z,
                            second_z = around_x * out_y - around_y * out_x;
                const float first_square = first_x * first_x + first_y * first_y + first_z * first_z;
                const float second_square = second_x * second_x + second_y * second_y + second_z * second_z;
                // first / |first| + second / |second|, times |first| |second|^2.
                const float product = first_square * second_square, both = std::sqrt(product);
                const float sum_x = second_square * first_x + both * second_x,
                            sum_y = second_square * first_y + both * second_y,
                            sum_z = second_square * first_z + both * second_z;
                const float square = sum_x * sum_x + sum_y * sum_y + sum_z * sum_z;
                were_lost[k] = (first_square > least_in ? 0U : 1U) | (second_square > least_out ? 0U : 1U) |
                               (square > kLeastSum * product * second_square + kLeastSquare ? 0U : 1U);
                sums.x[k] = sum_x;
                sums.y[k] = sum_y;
                sums.z[k] = sum_z;
                squares[k] = square;
            }
        }

        TUFTWAVE_BODY bool lost_any() const {
            std::uint32_t any = 0;
            for (std::size_t k = 0; k < kRow; ++k) any |= were_lost[k];
            return any != 0;
        }

        TUFTWAVE_BODY void normalize(Rows& normals) const {
            for (std::size_t k = 0; k < kRow; ++k) {
                const float unit = 1 / std::sqrt(squares[k]);
                normals.x[k] = unit * sums.x[k];
                normals.y[k] = unit * sums.y[k];
                normals.z[k] = unit * sums.z[k];
            }
        }
    };

    TUFTWAVE_BODY Surface(const MeshPlan& plan, double scale, const SurfaceSpans& out)
        : plan_(plan),
          corners_(corners_of(plan.sides)),
          scale_(scale),
          positions_(out.positions, 3 * (corners_.count() + 1)),
          normals_(out.normals, 3 * (corners_.count() + 1)) {
        whole_.fill(1);
    }

    TUFTWAVE_BODY void write_rings(const SurfaceSpans& out, std::vector<std::size_t>& left) {
        const std::size_t count = plan_.rings.size();
        Offsets rings[2];
        Ways ways[2];
        Sums sums[2];  // one ring's wait for the next one's: two roots one after the other take long
        rings[1].middle = plan_.root;
        write_positions(0, rings[0]);
        ways[0].find(rings[1], rings[0], scale_);
        for (std::size_t i = 0; i < count; ++i) {
            Offsets &here = rings[i % 2], &after = rings[(i + 1) % 2];
            if (i + 1 < count) {
                write_positions(i + 1, after);
            } else if (plan_.flat_tip) {
                after = here;
            } else {
                after = {};
                after.middle = plan_.tip;
            }
            ways[(i + 1) % 2].find(here, after, scale_);
            sums[i % 2].find(here, ways[i % 2], ways[(i + 1) % 2]);
            if (i > 0) write_normals(i - 1, sums[(i + 1) % 2], left);
        }
        write_normals(count - 1, sums[(count - 1) % 2], left);
        write_uvs(out.uvs);
    }

    TUFTWAVE_BODY void write_positions(std::size_t at, Offsets& offsets) {
        const Ring ring = plan_.rings[at];
        const Point middle(ring.frame.point), up(ring.half_thickness * ring.frame.normal),
            across(ring.half_width * ring.frame.binormal());
        const auto unit = static_cast<float>(scale_);
        const std::span<const float> shares = plan_.reach.of(at);
        const float* const reach = shares.empty() ? whole_.data() : shares.data();
        const float *cosines = corners_.short_cosines(), *sines = corners_.short_sines();
        Rows places;
        for (std::size_t k = 0; k < kRow; ++k) {
            const float cosine = reach[k] * cosines[k], sine = reach[k] * sines[k];
            const float x = cosine * up.x + sine * across.x, y = cosine * up.y + sine * across.y,
                        z = cosine * up.z + sine * across.z;
            offsets.x[Offsets::kFirst + k] = unit * x;
            offsets.y[Offsets::kFirst + k] = unit * y;
            offsets.z[Offsets::kFirst + k] = unit * z;
            places.x[k] = middle.x + x;
            places.y[k] = middle.y + y;
            places.z[k] = middle.z + z;
        }
        offsets.close(corners_);
        offsets.middle = ring.frame.point;
        offsets.width = scale_ * ring.half_width;
        positions_.write(places.interleaved());
    }

    TUFTWAVE_BODY void write_normals(std::size_t ring, const Sums& sums, std::vector<std::size_t>& left) {
        if (sums.lost_any()) left.push_back(ring);
        Rows normals;
        sums.normalize(normals);
        normals_.write(normals.interleaved());
    }

    TUFTWAVE_BODY void write_uvs(std::span<float> uvs) const {
        alignas(64) Row across;
        for (std::size_t k = 0; k < kRow; ++k)
            across[k] = static_cast<float>(static_cast<double>(k) / static_cast<double>(corners_.count()));
        RowWriter<2 * kRow> to(uvs, 2 * (corners_.count() + 1));
        for (const double ring : plan_.rings.along()) {
            const auto along = static_cast<float>(ring);
            to.write([&](float* row) {
                for (std::size_t k = 0; k < kRow; ++k) {
                    row[2 * k] = across[k];
                    row[2 * k + 1] = along;
                }
            });
        }
    }

    const MeshPlan& plan_;
    const Corners& corners_;
    const double scale_;
    alignas(64) Row whole_;  // the reach of rings that keep all of it
    RowWriter<3 * kRow> positions_, normals_;
};

}  // namespace

std::vector<std::size_t> write_surface_quickly(const MeshPlan& plan, Vectors vectors, const SurfaceSpans& out) {
    std::vector<std::size_t> left;
    with_row_of(corners_of(plan.sides),
                [&]<std::size_t kRow>() { run_with<Surface<kRow>::write>(vectors, plan, scale_of(plan), out, left); });
    return left;
}

}  // namespace tuftwave
