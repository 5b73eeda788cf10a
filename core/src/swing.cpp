// Based on: K. Furukawa, S. Nakata, 2018, section 2, discretisation in space.
// Differs: in model space all bones of a chain turn about one axis a, so that a bone's own turn is that by the
// difference of its angle and its parent's, and its local rotation lies on one great circle: cos(half) A + sin(half) B,
// where A and B are the same in all pictures.
#include "swing.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "close_bodies.hpp"

namespace tuftwave {
namespace {

constexpr std::size_t kLanes = 8;  // bones at a time

/// A number of each of some bones. Loops over nothing else become vectors.
struct Lanes {
    double at[kLanes];
};

std::size_t in_lanes(std::size_t count) { return (count + kLanes - 1) / kLanes * kLanes; }

TUFTWAVE_BODY void store(const Lanes& lanes, double* to) {
    for (std::size_t i = 0; i < kLanes; ++i) to[i] = lanes.at[i];
}

/// Numbers of one chain in rows, a bone or a node to a column. Lanes may be loaded from any bone's column or the next;
/// what is beyond the last is 0.
class Rows {
  public:
    Rows(std::size_t bone_count, std::span<const double> phases)
        : bones(bone_count),
          pictures(phases.size()),
          row_(in_lanes(bones) + kLanes),
          rows_((kRowCount + pictures) * row_ + 3 * in_lanes(pictures)) {
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
    double* angles(std::size_t picture) { return row(kRowCount + picture); }
    double* shifts() { return row(8); }  // to be taken out of the angles
    // Of bones.
    double* still(std::size_t part) { return row(9 + part); }    // A
    double* turned(std::size_t part) { return row(13 + part); }  // B
    double* half_cosine() { return row(17); }                    // of a bone's own turn in the picture before
    double* half_sine() { return row(18); }
    // Of pictures.
    double* phase() { return row(kRowCount + pictures); }
    double* phase_cosine() { return phase() + in_lanes(pictures); }
    double* phase_sine() { return phase_cosine() + in_lanes(pictures); }

  private:
    static constexpr std::size_t kRowCount = 19;

    double* row(std::size_t index) { return rows_.data() + index * row_; }

    std::size_t row_;
    std::vector<double> rows_;
};

void write_line(const Chain& chain, const Wave& wave, Rows& of) {
    double* const along = of.along();
    for (std::size_t i = 0; i < of.bones; ++i) along[i + 1] = along[i] + length(chain.nodes[i + 1] - chain.nodes[i]);
    const double whole = along[of.bones];
    for (std::size_t i = 0; i < of.bones; ++i) {
        const double share = whole > 0 ? along[i] / whole : static_cast<double>(i) / static_cast<double>(of.bones);
        along[i] = kPi * share;
    }
    along[of.bones] = kPi;
    for (std::size_t i = 0; i <= of.bones; ++i) of.envelope()[i] = wave_envelope(wave, along[i]);
}

void write_lifted(const Chain& chain, const Laying& laying, Rows& of) {
    const auto write = [&](std::size_t column, const Quat& q) {
        of.lifted(0)[column] = q.x;
        of.lifted(1)[column] = q.y;
        of.lifted(2)[column] = q.z;
        of.lifted(3)[column] = q.w;
    };
    Quat rest = normalized(chain.parent_rotation);
    write(0, rest);
    for (std::size_t i = 0; i < of.bones; ++i) {
        rest = rest * normalized(chain.rest_rotations[i]);
        write(1 + i, laying.lift(i) * rest);
    }
}

TUFTWAVE_BODY void write_circles(Rows& of, std::size_t first, const Vec3& axis) {
    const double *const px = of.lifted(0) + first, *const x = of.lifted(0) + 1 + first;
    const double *const py = of.lifted(1) + first, *const y = of.lifted(1) + 1 + first;
    const double *const pz = of.lifted(2) + first, *const z = of.lifted(2) + 1 + first;
    const double *const pw = of.lifted(3) + first, *const w = of.lifted(3) + 1 + first;
    Lanes ax, ay, az, aw, bx, by, bz, bw;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const Quat back{-px[i], -py[i], -pz[i], pw[i]}, lifted{x[i], y[i], z[i], w[i]};
        const Quat a = back * lifted, b = back * (Quat{axis.x, axis.y, axis.z, 0} * lifted);
        ax.at[i] = a.x, ay.at[i] = a.y, az.at[i] = a.z, aw.at[i] = a.w;
        bx.at[i] = b.x, by.at[i] = b.y, bz.at[i] = b.z, bw.at[i] = b.w;
    }
    store(ax, of.still(0) + first), store(bx, of.turned(0) + first);
    store(ay, of.still(1) + first), store(by, of.turned(1) + first);
    store(az, of.still(2) + first), store(bz, of.turned(2) + first);
    store(aw, of.still(3) + first), store(bw, of.turned(3) + first);
}

TUFTWAVE_BODY void write_sincos(const double* x, double divisor, std::size_t count, double* sine, double* cosine) {
    for (std::size_t first = 0; first < count; first += kLanes) {
        const double* const from = x + first;
        Lanes sines, cosines;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const elementary::SinCos both = elementary::bodies::sincos(from[i] / divisor);
            sines.at[i] = both.sin;
            cosines.at[i] = both.cos;
        }
        store(sines, sine + first);
        store(cosines, cosine + first);
    }
}

/// Writes the chords' angles of the hair line, and what is to be taken out of them, of the bones from `first` on.
TUFTWAVE_BODY void write_angles(Rows& of, std::size_t first, double one_over_s, Shift shift) {
    const double *const cosine = of.cosine() + first, *const next_cosine = of.cosine() + first + 1;
    const double *const sine = of.sine() + first, *const next_sine = of.sine() + first + 1;
    const double *const envelope = of.envelope() + first, *const next_envelope = of.envelope() + first + 1;
    const double *const along = of.along() + first, *const next_along = of.along() + first + 1;
    // The sum must be the same in any order, so that a chain some pictures ahead has the same mean to the last bit: of
    // angles rounded to multiples of 2^-44, and of the rest to those of 2^-90, sums of two hundred are exact.
    constexpr double kToCoarse = 0x1.8p8, kToFine = 0x1.8p-38;
    Lanes coarse_sum{}, fine_sum{}, least{}, shifts;
    for (std::size_t n = 0; n < of.pictures; ++n) {
        const double c = of.phase_cosine()[n], s = of.phase_sine()[n];
        Lanes angles;
        for (std::size_t i = 0; i < kLanes; ++i) {  // eq. (1), with cos(x/k - psi) as a sum
            const double height = envelope[i] * ((cosine[i] * c + sine[i] * s) + one_over_s);
            const double next = next_envelope[i] * ((next_cosine[i] * c + next_sine[i] * s) + one_over_s);
            const double run = std::max(next_along[i] - along[i], 0.0);  // behind the tip there is none
            const double angle = elementary::bodies::slope_angle(next - height, run);
            const double coarse = (angle + kToCoarse) - kToCoarse;
            coarse_sum.at[i] += coarse;
            fine_sum.at[i] += ((angle - coarse) + kToFine) - kToFine;
            least.at[i] = n == 0 ? angle : std::min(least.at[i], angle);
            angles.at[i] = angle;
        }
        store(angles, of.angles(n) + 1 + first);
    }
    const auto count = static_cast<double>(of.pictures);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double mean = (coarse_sum.at[i] + fine_sum.at[i]) / count;
        shifts.at[i] = shift == Shift::kNone ? 0 : shift == Shift::kLeast ? least.at[i] : mean;
    }
    store(shifts, of.shifts() + 1 + first);
}

/// Writes the local rotations of the bones from `first` on, as many as there are lanes. Of q and -q, which are one
/// rotation, the first picture takes that with w >= 0, the others that nearer to the picture before: on a great circle,
/// that is as near as the cosines and sines are.
TUFTWAVE_BODY void write_rotations(Rows& of, std::size_t first, std::size_t picture, Quat* out) {
    const double *const ax = of.still(0) + first, *const bx = of.turned(0) + first;
    const double *const ay = of.still(1) + first, *const by = of.turned(1) + first;
    const double *const az = of.still(2) + first, *const bz = of.turned(2) + first;
    const double *const aw = of.still(3) + first, *const bw = of.turned(3) + first;
    const double *const shift = of.shifts() + 1 + first, *const parent_shift = of.shifts() + first;
    const double *const angle = of.angles(picture) + 1 + first, *const parent = of.angles(picture) + first;
    const double* const before_cosine = (picture == 0 ? of.still(3) : of.half_cosine()) + first;
    const double* const before_sine = (picture == 0 ? of.turned(3) : of.half_sine()) + first;
    Lanes cosine, sine;
    double turns[4 * kLanes];
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double half = ((angle[i] - shift[i]) - (parent[i] - parent_shift[i])) / 2;
        const elementary::SinCos turn = elementary::bodies::close_sincos(half);
        const double sign = turn.cos * before_cosine[i] + turn.sin * before_sine[i] < 0 ? -1 : 1;
        const double c = sign * turn.cos, s = sign * turn.sin;
        cosine.at[i] = c;
        sine.at[i] = s;
        turns[4 * i] = c * ax[i] + s * bx[i];
        turns[4 * i + 1] = c * ay[i] + s * by[i];
        turns[4 * i + 2] = c * az[i] + s * bz[i];
        turns[4 * i + 3] = c * aw[i] + s * bw[i];
    }
    store(cosine, of.half_cosine() + first);
    store(sine, of.half_sine() + first);
    for (std::size_t i = 0; i < kLanes; ++i)
        out[i] = {turns[4 * i], turns[4 * i + 1], turns[4 * i + 2], turns[4 * i + 3]};
}

/// @param out   what is written past a picture's rotations is written over by the next
/// @param room  for one picture in whole lanes, where they would pass the end of all
TUFTWAVE_BODY void write_chain(Rows& of, const Wave& wave, Shift shift, const Vec3& axis, std::span<Quat> out,
                               std::span<Quat> room) {
    // k: spatial period, s: lightness
    const double k = wave.spatial_period, s = wave.lightness;
    for (std::size_t first = 0; first < of.bones; first += kLanes) write_circles(of, first, axis);
    write_sincos(of.along(), k, of.bones + 1, of.sine(), of.cosine());
    write_sincos(of.phase(), 1, of.pictures, of.phase_sine(), of.phase_cosine());
    for (std::size_t first = 0; first < of.bones; first += kLanes) write_angles(of, first, 1 / s, shift);
    for (std::size_t n = 0; n < of.pictures; ++n) {
        Quat* const place = &out[n * (of.bones + 1)];
        const bool fits = n * (of.bones + 1) + room.size() <= out.size();
        for (std::size_t first = 0; first < of.bones; first += kLanes)
            write_rotations(of, first, n, (fits ? place : room.data()) + first);
        if (!fits) std::copy_n(room.begin(), of.bones, place);
    }
}

}  // namespace

std::vector<Quat> swing(const Chain& chain, const Laying& laying, const Wave& wave, std::span<const double> phases,
                        Shift shift, Vectors vectors) {
    const std::size_t nodes = chain.nodes.size(), count = nodes * phases.size();
    Rows rows(nodes - 1, phases);
    write_line(chain, wave, rows);
    write_lifted(chain, laying, rows);
    std::vector<Quat> rotations(count), room(in_lanes(nodes - 1));
    run_with<write_chain>(vectors, rows, wave, shift, laying.axis(), rotations, room);

    Quat tip = normalized(chain.rest_rotations.back());
    if (tip.w < 0) tip = -tip;
    for (std::size_t at = nodes - 1; at < count; at += nodes) rotations[at] = tip;
    return rotations;
}

}  // namespace tuftwave
