// Based on: K. Furukawa, S. Nakata, 2018, section 2, discretisation in space.
// Differs: in model space all bones of a chain turn about one axis a, so that a bone's own turn is that by the
// difference of its angle and its parent's, and its local rotation lies on one great circle: cos(half) A + sin(half) B,
// where A and B are the same in all pictures.
#include "swing.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "close_bodies.hpp"
#include "laying.hpp"

namespace tuftwave {
namespace {

constexpr std::size_t kLanes = 8;  // numbers at a time, at most

// Rows that a loop reads and writes; none is both. Loops over nothing else become vectors.
using In = const double* __restrict;
using Out = double* __restrict;

std::size_t in_lanes(std::size_t count) { return (count + kLanes - 1) / kLanes * kLanes; }

/// Numbers of one chain in rows, a bone or a node to a column. Rows are whole lanes long, from any bone's column or the
/// next; what is beyond the last is of no use but finite.
class Rows {
  public:
    Rows(std::size_t bone_count, std::span<const double> phases)
        : bones(bone_count),
          pictures(phases.size()),
          row_(in_lanes(bones) + kLanes),
          rows_((kRowCount + 3 * pictures) * row_ + 3 * in_lanes(pictures)) {
        std::copy(phases.begin(), phases.end(), phase());
    }

    std::size_t bones, pictures;

    // Of nodes.
    double* along() { return row(0); }   // from the root, where the chain is pi long
    double* cosine() { return row(1); }  // of along/k
    double* sine() { return row(2); }
    double* envelope() { return row(3); }
    // Of bones, behind what the chain hangs on: its angles are 0.
    double* lifted(std::size_t part) { return row(4 + part); }  // x, y, z, w at rest and lifted, in model space
    double* shifts() { return row(8); }                         // to be taken out of the angles
    // Of bones.
    double* still(std::size_t part) { return row(9 + part); }    // A
    double* turned(std::size_t part) { return row(13 + part); }  // B
    double* runs() { return row(17); }                           // along the line
    double* sums() { return row(18); }                           // of the angles in all pictures
    double* rests() { return row(19); }                          // of those sums
    double* unit(std::size_t part) { return row(20 + part); }    // x, y, z, w of its rest rotation
    // Of one picture.
    double* heights(std::size_t picture) { return row(kRowCount + 3 * picture); }  // of nodes
    double* angles(std::size_t picture) { return row(kRowCount + 3 * picture + 1); }
    double* half_cosine(std::size_t picture) { return heights(picture); }  // of a bone's own turn, in their place
    double* half_sine(std::size_t picture) { return row(kRowCount + 3 * picture + 2); }
    // Of pictures.
    double* phase() { return row(kRowCount + 3 * pictures); }
    double* phase_cosine() { return phase() + in_lanes(pictures); }
    double* phase_sine() { return phase_cosine() + in_lanes(pictures); }

  private:
    static constexpr std::size_t kRowCount = 24;

    double* row(std::size_t index) { return rows_.data() + index * row_; }

    std::size_t row_;
    std::vector<double> rows_;
};

/// Writes how far nodes are from the root, metres.
void write_lengths(const Chain& chain, Rows& of) {
    double* const along = of.along();
    for (std::size_t i = 0; i < of.bones; ++i) along[i + 1] = along[i] + length(chain.nodes[i + 1] - chain.nodes[i]);
}

/// @param of  with lengths
TUFTWAVE_BODY void write_line(const Wave& wave, Rows& of) {
    double* const along = of.along();
    const double whole = along[of.bones];
    for (std::size_t i = 0; i < of.bones; ++i) {
        const double share = whole > 0 ? along[i] / whole : static_cast<double>(i) / static_cast<double>(of.bones);
        along[i] = kPi * share;
    }
    along[of.bones] = kPi;
    for (std::size_t i = 0; i <= of.bones; ++i) of.envelope()[i] = wave_envelope(wave, along[i]);
    for (std::size_t i = 0; i < of.bones; ++i) of.runs()[i] = along[i + 1] - along[i];
}

TUFTWAVE_BODY void write_lifted(const Chain& chain, const Laying& laying, Rows& of) {
    const auto write = [&](std::size_t column, const Quat& q) {
        of.lifted(0)[column] = q.x;
        of.lifted(1)[column] = q.y;
        of.lifted(2)[column] = q.z;
        of.lifted(3)[column] = q.w;
    };
    Quat rest = normalized(chain.parent_rotation);
    write(0, rest);
    for (std::size_t i = 0; i < of.bones; ++i) {
        rest = rest * Quat{of.unit(0)[i], of.unit(1)[i], of.unit(2)[i], of.unit(3)[i]};
        write(1 + i, laying.lift(i) * rest);
    }
}

/// Writes unit quaternions.
TUFTWAVE_BODY void write_units(const Quat* __restrict from, std::size_t count, Out x, Out y, Out z, Out w) {
    for (std::size_t i = 0; i < count; ++i) {
        const Quat unit = normalized(from[i]);
        x[i] = unit.x, y[i] = unit.y, z[i] = unit.z, w[i] = unit.w;
    }
}

/// Writes A and B of the bones from `first` on, as many as there are lanes.
TUFTWAVE_BODY void write_circles(Rows& of, std::size_t first, const Vec3& axis) {
    In px = of.lifted(0) + first, py = of.lifted(1) + first, pz = of.lifted(2) + first, pw = of.lifted(3) + first;
    In x = px + 1, y = py + 1, z = pz + 1, w = pw + 1;
    double a[4][kLanes], b[4][kLanes];
    for (std::size_t i = 0; i < kLanes; ++i) {
        const Quat back{-px[i], -py[i], -pz[i], pw[i]}, lifted{x[i], y[i], z[i], w[i]};
        const Quat still = back * lifted, turned = back * (Quat{axis.x, axis.y, axis.z, 0} * lifted);
        a[0][i] = still.x, a[1][i] = still.y, a[2][i] = still.z, a[3][i] = still.w;
        b[0][i] = turned.x, b[1][i] = turned.y, b[2][i] = turned.z, b[3][i] = turned.w;
    }
    for (std::size_t part = 0; part < 4; ++part) {
        std::copy_n(a[part], kLanes, of.still(part) + first);
        std::copy_n(b[part], kLanes, of.turned(part) + first);
    }
}

TUFTWAVE_BODY void write_sincos(In x, double divisor, std::size_t count, Out sine, Out cosine) {
    for (std::size_t i = 0; i < count; ++i) {
        const elementary::SinCos both = elementary::bodies::sincos(x[i] / divisor);
        sine[i] = both.sin;
        cosine[i] = both.cos;
    }
}

TUFTWAVE_BODY void write_heights(In envelope, In cosine, In sine, double phase_cosine, double phase_sine,
                                 double one_over_s, std::size_t count, Out heights) {
    for (std::size_t i = 0; i < count; ++i)  // eq. (1), with cos(x/k - psi) as a sum
        heights[i] = envelope[i] * ((cosine[i] * phase_cosine + sine[i] * phase_sine) + one_over_s);
}

TUFTWAVE_BODY void write_angles(In heights, In runs, std::size_t count, Out angles) {
    for (std::size_t i = 0; i < count; ++i)
        angles[i] = elementary::bodies::slope_angle(heights[i + 1] - heights[i], runs[i]);
}

TUFTWAVE_BODY void add_angles(In angles, std::size_t count, Out sums, Out rests) {
    // The sum must be the same in any order, so that a chain some pictures ahead has the same mean to the last bit: of
    // angles rounded to multiples of 2^-44, and of the rest to those of 2^-90, sums of two hundred are exact.
    constexpr double kToCoarse = 0x1.8p8, kToFine = 0x1.8p-38;
    for (std::size_t i = 0; i < count; ++i) {
        const double coarse = (angles[i] + kToCoarse) - kToCoarse;
        sums[i] += coarse;
        rests[i] += ((angles[i] - coarse) + kToFine) - kToFine;
    }
}

TUFTWAVE_BODY void write_least(In angles, std::size_t count, Out least) {
    for (std::size_t i = 0; i < count; ++i) least[i] = std::min(least[i], angles[i]);
}

/// Writes what is to be taken out of the angles.
TUFTWAVE_BODY void write_shifts(Rows& of, Shift shift, std::size_t count) {
    double* const shifts = of.shifts() + 1;
    if (shift == Shift::kLeast) {
        std::copy_n(of.angles(0) + 1, count, shifts);
        for (std::size_t n = 1; n < of.pictures; ++n) write_least(of.angles(n) + 1, count, shifts);
    }
    if (shift == Shift::kMean) {
        for (std::size_t n = 0; n < of.pictures; ++n) add_angles(of.angles(n) + 1, count, of.sums(), of.rests());
        const auto pictures = static_cast<double>(of.pictures);
        for (std::size_t i = 0; i < count; ++i) shifts[i] = (of.sums()[i] + of.rests()[i]) / pictures;
    }
}

/// @param angles, shifts  behind the parents'
TUFTWAVE_BODY void write_half_turns(In angles, In shifts, std::size_t count, Out cosine, Out sine) {
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = (angles[i + 1] - shifts[i + 1]) - (angles[i] - shifts[i]);
        const elementary::SinCos turn = elementary::bodies::close_sincos(angle / 2);
        cosine[i] = turn.cos;
        sine[i] = turn.sin;
    }
}

/// Of q and -q, which are one rotation, takes that nearer to the picture before: on a great circle, that is as near as
/// the cosines and sines are.
TUFTWAVE_BODY void choose_signs(In cosine_before, In sine_before, std::size_t count, Out cosine, Out sine) {
    for (std::size_t i = 0; i < count; ++i) {
        const double sign = cosine[i] * cosine_before[i] + sine[i] * sine_before[i] < 0 ? -1 : 1;
        cosine[i] *= sign;
        sine[i] *= sign;
    }
}

/// Writes the local rotations in one picture.
TUFTWAVE_BODY void write_rotations(Rows& of, std::size_t picture, Quat* __restrict out) {
    In ax = of.still(0), ay = of.still(1), az = of.still(2), aw = of.still(3);
    In bx = of.turned(0), by = of.turned(1), bz = of.turned(2), bw = of.turned(3);
    In cosine = of.half_cosine(picture), sine = of.half_sine(picture);
    for (std::size_t i = 0; i < of.bones; ++i) {
        const double c = cosine[i], s = sine[i];
        out[i] = {c * ax[i] + s * bx[i], c * ay[i] + s * by[i], c * az[i] + s * bz[i], c * aw[i] + s * bw[i]};
    }
}

TUFTWAVE_BODY void write_chain(const Chain& chain, const Laying& laying, const Wave& wave, Shift shift, Rows& of,
                               std::span<Quat> rotations) {
    // k: spatial period, s: lightness
    const double k = wave.spatial_period, s = wave.lightness;
    const std::size_t bones = in_lanes(of.bones), nodes = in_lanes(of.bones + 1);
    write_line(wave, of);
    write_units(chain.rest_rotations.data(), of.bones, of.unit(0), of.unit(1), of.unit(2), of.unit(3));
    write_lifted(chain, laying, of);
    for (std::size_t first = 0; first < of.bones; first += kLanes) write_circles(of, first, laying.axis());
    write_sincos(of.along(), k, nodes, of.sine(), of.cosine());
    write_sincos(of.phase(), 1, in_lanes(of.pictures), of.phase_sine(), of.phase_cosine());
    for (std::size_t n = 0; n < of.pictures; ++n)
        write_heights(of.envelope(), of.cosine(), of.sine(), of.phase_cosine()[n], of.phase_sine()[n], 1 / s, nodes,
                      of.heights(n));
    for (std::size_t n = 0; n < of.pictures; ++n) write_angles(of.heights(n), of.runs(), bones, of.angles(n) + 1);
    write_shifts(of, shift, bones);
    for (std::size_t n = 0; n < of.pictures; ++n)
        write_half_turns(of.angles(n), of.shifts(), bones, of.half_cosine(n), of.half_sine(n));
    choose_signs(of.still(3), of.turned(3), bones, of.half_cosine(0), of.half_sine(0));  // so that w >= 0
    for (std::size_t n = 1; n < of.pictures; ++n)
        choose_signs(of.half_cosine(n - 1), of.half_sine(n - 1), bones, of.half_cosine(n), of.half_sine(n));
    for (std::size_t n = 0; n < of.pictures; ++n) write_rotations(of, n, &rotations[n * (of.bones + 1)]);
}

}  // namespace

std::vector<Quat> swing(const Chain& chain, const Motion& motion, std::span<const double> phases, Shift shift,
                        Vectors vectors) {
    const std::size_t nodes = chain.nodes.size();
    Rows rows(nodes - 1, phases);
    write_lengths(chain, rows);
    const Laying laying(chain, rows.along()[nodes - 1], motion);
    const Quat tip = normalized(chain.rest_rotations.back());
    std::vector<Quat> rotations(nodes * phases.size(), tip.w < 0 ? -tip : tip);
    run_with<write_chain>(vectors, chain, laying, motion.wave, shift, rows, rotations);
    return rotations;
}

}  // namespace tuftwave
