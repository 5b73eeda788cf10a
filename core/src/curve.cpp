// Based on: Shimosoyama, Yamamoto, Noma. NPR Hair Modeling by Controlling the Shape of Tufts. Section 3.1 (composite
// cubic Bezier through the points). C. Yuksel, S. Schaefer, J. Keyser. Parameterization and applications of
// Catmull-Rom curves. 2011 (centripetal knots). W. Wang et al. Computation of rotation minimizing frames. 2008
// (double reflection).
// Differs: a stroke that doubles back on itself, where the tangent vanishes, gets a tight hairpin in place of a cusp.
#include "tuftwave/curve.hpp"

#include <algorithm>
#include <array>

#include "bezier.hpp"
#include "place_search.hpp"
#include "tuftwave/elementary.hpp"

namespace tuftwave {
namespace {

/// Points nearer than this share of the stroke's length to the one before are merged into it.
constexpr double kMergeShare = 1e-9;

/// Between two samples the tangent turns less than this, radians (about 11 degrees), unless the halving bottoms out.
constexpr double kSampleTurn = 0.2;
constexpr std::size_t kFirstSamples = 4;  // per Bezier segment
constexpr std::size_t kUsualSamples = 6;  // likewise, where some had to be halved
constexpr int kDeepestHalving = 8;        // 4 x 256 samples per segment at most

/// A tangent shorter than this share of a usual one counts as vanished.
constexpr double kVanishedTangent = 1e-6;
/// Tangent of a hairpin as a share of a usual one: the turn takes about a tenth of the neighbouring segment.
constexpr double kHairpinTangent = 0.1;

constexpr double kUnknownArc = -1;  // of a piece, until all are measured at once

/// Newton's steps towards a given arc length: three or four are usual, a vanishing tangent takes halvings.
constexpr int kMostNewtonSteps = 50;

std::vector<Vec3> merged(std::span<const Vec3> points) {
    double whole = 0;
    for (std::size_t i = 1; i < points.size(); ++i) whole += length(points[i] - points[i - 1]);
    std::vector<Vec3> kept;
    for (const Vec3& point : points) {
        if (kept.empty() || length(point - kept.back()) > kMergeShare * whole) kept.push_back(point);
    }
    return kept;
}

/// The centripetal Catmull-Rom tangent between two chords, per unit of knot distance.
/// @param d1, d2  knot distances of the chords
Vec3 centripetal_tangent(const Vec3& before, const Vec3& after, double d1, double d2) {
    const Vec3 tangent = 1 / d1 * before - 1 / (d1 + d2) * (before + after) + 1 / d2 * after;
    const double usual = std::min(d1, d2);
    if (length(tangent) > kVanishedTangent * usual) return tangent;
    return kHairpinTangent * usual * any_perpendicular(normalized(before));
}

/// Steps from sample to sample.
struct Steps {
    static constexpr std::size_t kMost = 64;
    using Row = std::array<double, kMost>;
    VectorRows<kMost> x, y, z;  // what a normal is multiplied by to be carried along, row by row
    alignas(64) Row forwards;   // 0 where the step tells nothing
    VectorRows<kMost> normals;
};

template <class Sample>
TUFTWAVE_BODY void find_steps(const Sample* samples, std::size_t count, Steps& to) {
    for (std::size_t k = 0; k < count; ++k) {
        const CurveFrame &from = samples[k].frame, &next = samples[k + 1].frame;
        const bezier::Step step(from.point, from.tangent, next.point, next.tangent);
        const Vec3 first = step.twice_first * step.first, second = step.twice_second * step.second,
                   through = step.second - step.coupling * step.first;
        to.x.set(k, Vec3{1, 0, 0} - first.x * step.first - second.x * through);
        to.y.set(k, Vec3{0, 1, 0} - first.y * step.first - second.y * through);
        to.z.set(k, Vec3{0, 0, 1} - first.z * step.first - second.z * through);
        to.forwards[k] = step.is_forwards ? 1.0 : 0.0;
    }
}

/// Rounding leaves a trace of the tangents in the normals.
template <class Sample>
TUFTWAVE_BODY void straighten_normals(const Sample* samples, std::size_t count, Steps& steps) {
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 upright = rejected(steps.normals[k], samples[k + 1].frame.tangent);
        steps.normals.set(k, 1 / length(upright) * upright);
    }
}

/// Pieces of segments that are measured at once.
struct Arcs {
    static constexpr std::size_t kMost = 16;
    VectorRows<kMost> constant, linear, quadratic;  // of the velocities
    alignas(64) std::array<double, kMost> from, to, length;

    TUFTWAVE_BODY static void find(Arcs& arcs, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) {
            const bezier::Velocity velocity{arcs.constant[k], arcs.linear[k], arcs.quadratic[k]};
            arcs.length[k] = velocity.arc(arcs.from[k], arcs.to[k]);
        }
    }
};

}  // namespace

/// What the samples of some segments are made of, before anything is known to turn too quickly; segments stand side by
/// side.
struct Curve::FirstSamples {
    static constexpr std::size_t kMost = 16, kVector = 4;  // segments
    static constexpr std::size_t kHalves = 2 * kFirstSamples;
    using Rows = VectorRows<kMost>;
    using Row = std::array<double, kMost>;
    Rows constant, linear, quadratic;                 // of the velocities
    std::array<Rows, kHalves> tangents;               // at the samples and halfway between; not finite at rest
    alignas(64) std::array<Row, kHalves> speeds;      // likewise
    alignas(64) std::array<Row, kHalves> turns;       // from the one before, radians; the first one's is not known
    alignas(64) std::array<Row, kFirstSamples> arcs;  // from sample to sample, metres

    TUFTWAVE_BODY static void take(FirstSamples& s, std::size_t padded) {
        for (std::size_t half = 0; half < kHalves; ++half) {
            const double t = static_cast<double>(half + 1) / kHalves;
            for (std::size_t k = 0; k < padded; ++k) {
                const Vec3 velocity = s.velocity(k).at(t);
                const double speed = length(velocity);
                s.speeds[half][k] = speed;
                s.tangents[half].set(k, 1 / speed * velocity);
            }
        }
        for (std::size_t half = 1; half < kHalves; ++half) {
            for (std::size_t k = 0; k < padded; ++k)
                s.turns[half][k] = length(s.tangents[half][k] - s.tangents[half - 1][k]);
        }
        for (std::size_t piece = 0; piece < kFirstSamples; ++piece) {
            const double from = static_cast<double>(piece) / kFirstSamples;
            for (std::size_t k = 0; k < padded; ++k)
                s.arcs[piece][k] = s.velocity(k).arc(from, from + 1.0 / kFirstSamples);
        }
    }

    TUFTWAVE_BODY bezier::Velocity velocity(std::size_t k) const { return {constant[k], linear[k], quadratic[k]}; }
};

bezier::Velocity Curve::Segment::velocity() const { return {constant, linear, quadratic}; }

Vec3 Curve::Segment::point(double t) const { return t == 1 ? end : start + velocity().way_to(t); }

double Curve::Segment::parameter(double t0, double t1, double wanted, double whole) const {
    const bezier::Velocity curve = velocity();
    double low = t0, high = t1, t = t0 + wanted / whole * (t1 - t0);
    for (int step = 0; step < kMostNewtonSteps; ++step) {
        const double beyond = curve.arc(t0, t) - wanted;
        if (std::abs(beyond) <= kArcTolerance * whole) break;
        (beyond > 0 ? high : low) = t;
        const double next = t - beyond / curve.speed(t);
        t = next > low && next < high ? next : (low + high) / 2;
    }
    return t;
}

Curve::Curve(std::span<const Vec3> points, Vectors vectors) : vectors_(vectors) {
    make_segments(merged(points));
    samples_.reserve(segments_.size() * kUsualSamples);
    measure();
    carry_normals();
}

void Curve::make_segments(std::span<const Vec3> p) {
    const std::size_t last = p.size() - 1;
    segments_.reserve(last);
    // A phantom point mirrored at each end makes the end tangent the chord.
    Vec3 chord = p[1] - p[0];
    double knot = std::sqrt(length(chord));
    Vec3 tangent = 1 / knot * chord;
    for (std::size_t i = 0; i < last; ++i) {
        const Vec3 after = i + 1 < last ? p[i + 2] - p[i + 1] : chord;
        const double knot_after = i + 1 < last ? std::sqrt(length(after)) : knot;
        const Vec3 next = i + 1 < last ? centripetal_tangent(chord, after, knot, knot_after) : 1 / knot * chord;
        const auto [constant, linear, quadratic] =
            bezier::Velocity::of(p[i], p[i] + knot / 3 * tangent, p[i + 1] - knot / 3 * next, p[i + 1]);
        segments_.push_back({p[i], p[i + 1], constant, linear, quadratic});
        tangent = next;
        chord = after;
        knot = knot_after;
    }
}

void Curve::measure() {
    // Where two points are neighbouring doubles, the Bezier points between them coincide.
    const auto [tangent, speed] = heading_at(0, 0, normalized(segments_[0].end - segments_[0].start));
    samples_.push_back({0, 0, 0, speed, speed, 0, 0, {segments_[0].start, tangent, any_perpendicular(tangent)}});
    FirstSamples first;
    for (std::size_t from = 0; from < segments_.size(); from += FirstSamples::kMost) {
        const std::size_t count = std::min(FirstSamples::kMost, segments_.size() - from);
        const std::size_t padded = (count + FirstSamples::kVector - 1) / FirstSamples::kVector * FirstSamples::kVector;
        for (std::size_t k = 0; k < padded; ++k) {
            const Segment& segment = segments_[from + std::min(k, count - 1)];
            first.constant.set(k, segment.constant);
            first.linear.set(k, segment.linear);
            first.quadratic.set(k, segment.quadratic);
        }
        run_with<FirstSamples::take>(vectors_, first, padded);
        for (std::size_t k = 0; k < count; ++k) measure(from + k, first, k);
    }
    find_unknown_arcs();
    for (std::size_t i = 1; i < samples_.size(); ++i) samples_[i].along += samples_[i - 1].along;
}

void Curve::find_unknown_arcs() {
    std::array<Sample*, Arcs::kMost> found;
    Arcs arcs;
    std::size_t count = 0;
    const auto measure = [&] {
        run_with<Arcs::find>(vectors_, arcs, count);
        for (std::size_t k = 0; k < count; ++k) found[k]->along = arcs.length[k];
        count = 0;
    };
    for (Sample& sample : samples_) {
        if (sample.along != kUnknownArc) continue;
        const Segment& segment = segments_[sample.segment];
        arcs.constant.set(count, segment.constant);
        arcs.linear.set(count, segment.linear);
        arcs.quadratic.set(count, segment.quadratic);
        arcs.from[count] = sample.from;
        arcs.to[count] = sample.t;
        found[count++] = &sample;
        if (count == Arcs::kMost) measure();
    }
    if (count > 0) measure();
}

void Curve::measure(std::size_t segment, const FirstSamples& first, std::size_t k) {
    for (std::size_t piece = 0; piece < kFirstSamples; ++piece) {
        const double from = static_cast<double>(piece) / kFirstSamples, t = from + 1.0 / kFirstSamples;
        const std::size_t half = 2 * piece, whole = half + 1;
        const Vec3 last = samples_.back().frame.tangent, middle = first.tangents[half][k];
        const double turn = (piece == 0 ? length(middle - last) : first.turns[half][k]) + first.turns[whole][k];
        const Heading end{first.tangents[whole][k], first.speeds[whole][k]};
        if (turn <= kSampleTurn) {
            add_sample(segment, from, t, end, first.arcs[piece][k], turn);
            continue;
        }
        const double speed = first.speeds[half][k];
        sample_up_to(segment, from, t, {speed > 0 ? middle : last, speed},
                     {end.speed > 0 ? end.tangent : last, end.speed}, 0);
    }
}

void Curve::sample_up_to(std::size_t segment, double from, double t, const Heading& between, const Heading& end,
                         int halvings) {
    const Vec3 start = samples_.back().frame.tangent;
    const double turn = length(between.tangent - start) + length(end.tangent - between.tangent);
    if (turn > kSampleTurn && halvings < kDeepestHalving) {
        const double middle = (from + t) / 2;
        sample_up_to(segment, from, middle, heading_at(segment, (from + middle) / 2, start), between, halvings + 1);
        sample_up_to(segment, middle, t, heading_at(segment, (middle + t) / 2, between.tangent), end, halvings + 1);
        return;
    }
    add_sample(segment, from, t, end, kUnknownArc, turn);
}

void Curve::add_sample(std::size_t segment, double from, double t, const Heading& end, double arc, double turn) {
    const Sample& last = samples_.back();
    const Segment& bezier = segments_[segment];
    const double from_speed = from > 0 ? last.speed : length(bezier.constant);
    samples_.push_back(
        {segment, from, t, from_speed, end.speed, arc, last.turning + turn, {bezier.point(t), end.tangent, {}}});
}

void Curve::carry_normals() {
    Steps steps;
    Vec3 normal = samples_.front().frame.normal;
    for (std::size_t start = 0; start + 1 < samples_.size(); start += Steps::kMost) {
        Sample* const samples = &samples_[start];
        const std::size_t count = std::min(Steps::kMost, samples_.size() - 1 - start);
        run_with<find_steps<Sample>>(vectors_, samples, count, steps);
        for (std::size_t k = 0; k < count; ++k) {
            if (steps.forwards[k] != 0) {
                normal = {dot(steps.x[k], normal), dot(steps.y[k], normal), dot(steps.z[k], normal)};
            } else {
                const Vec3& tangent = samples[k + 1].frame.tangent;
                const Vec3 upright = rejected(normal, tangent);
                const double size = length(upright);
                normal = size > bezier::kLeastNormal ? upright / size : any_perpendicular(tangent);
            }
            steps.normals.set(k, normal);
        }
        run_with<straighten_normals<Sample>>(vectors_, samples, count, steps);
        for (std::size_t k = 0; k < count; ++k) samples[k + 1].frame.normal = steps.normals[k];
        normal = samples[count].frame.normal;
    }
}

Curve::Heading Curve::heading_at(std::size_t segment, double t, const Vec3& otherwise) const {
    const Vec3 velocity = segments_[segment].velocity().at(t);
    const double speed = length(velocity);
    return {speed > 0 ? velocity / speed : otherwise, speed};
}

inline std::size_t Curve::sample_before(double along, std::size_t guess) const {
    while (guess + 2 < samples_.size() && samples_[guess + 1].along <= along) ++guess;
    if (samples_[guess].along <= along) return guess;
    const auto after = std::upper_bound(samples_.begin() + 1, samples_.end() - 1, along,
                                        [](double value, const Sample& sample) { return value < sample.along; });
    return static_cast<std::size_t>(after - samples_.begin()) - 1;
}

CurveFrame Curve::at(double along) const {
    CurveFrame frame;
    at({&along, 1}, {&frame, 1});
    return frame;
}

void Curve::at(std::span<const double> along, std::span<CurveFrame> out) const {
    std::array<std::size_t, PlaceSearch::kMost> pieces;
    std::size_t before = 0;
    for (std::size_t from = 0; from < along.size(); from += pieces.size()) {
        const auto here = along.subspan(from, std::min(pieces.size(), along.size() - from));
        for (std::size_t k = 0; k < here.size(); ++k)
            pieces[k] = before = sample_before(std::clamp(here[k], 0.0, arc_length()), before);
        find(here, pieces, out.subspan(from, here.size()));
    }
}

void Curve::at_parts(std::span<const double> parts, double turn_worth, std::span<double> along,
                     std::span<CurveFrame> out) const {
    const auto measure = [&](const Sample& sample) { return sample.along + turn_worth * sample.turning; };
    const double whole = measure(samples_.back());
    std::array<std::size_t, PlaceSearch::kMost> pieces;
    std::size_t before = 0;  // the sample that a piece starts at
    double start = 0, end = measure(samples_[1]);
    for (std::size_t from = 0; from < parts.size(); from += pieces.size()) {
        const std::size_t count = std::min(pieces.size(), parts.size() - from);
        for (std::size_t k = 0; k < count; ++k) {
            const double wanted = parts[from + k] * whole;
            if (wanted < start) {
                before = 0;
                start = 0;
                end = measure(samples_[1]);
            }
            while (wanted > end && before + 2 < samples_.size()) {
                ++before;
                start = end;
                end = measure(samples_[before + 1]);
            }
            const double a = samples_[before].along, b = samples_[before + 1].along;
            along[from + k] = wanted < end ? a + (wanted - start) / (end - start) * (b - a) : b;
            pieces[k] = before;
        }
        find(along.subspan(from, count), pieces, out.subspan(from, count));
    }
}

void Curve::find(std::span<const double> along, std::span<const std::size_t> pieces, std::span<CurveFrame> out) const {
    const std::size_t count = along.size();
    PlaceSearch search;
    for (std::size_t k = 0; k < count; ++k) {
        const Sample &a = samples_[pieces[k]], &b = samples_[pieces[k] + 1];
        const Segment& bezier = segments_[b.segment];
        search.start.set(k, bezier.start);
        search.constant.set(k, bezier.constant);
        search.linear.set(k, bezier.linear);
        search.quadratic.set(k, bezier.quadratic);
        search.t0[k] = b.from;
        search.t1[k] = b.t;
        search.speed0[k] = b.from_speed;
        search.speed1[k] = b.speed;
        search.wanted[k] = along[k] - a.along;
        search.whole[k] = b.along - a.along;
        search.point.set(k, a.frame.point);
        search.tangent.set(k, a.frame.tangent);
        search.normal.set(k, a.frame.normal);
    }
    search.find_parameters(count, vectors_);
    for (std::size_t k = 0; k < count; ++k) {
        if (search.missed[k] == 0 || !(search.whole[k] > 0)) continue;
        const Segment& bezier = segments_[samples_[pieces[k] + 1].segment];
        search.t[k] = bezier.parameter(search.t0[k], search.t1[k], search.wanted[k], search.whole[k]);
    }
    search.find_frames(count, vectors_);
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 tangent = search.tangent[k];
        out[k] = {search.point[k], tangent, search.normal_size[k] > 0 ? search.normal[k] : any_perpendicular(tangent)};
        if (!(search.whole[k] > 0)) out[k] = samples_[pieces[k]].frame;
        if (along[k] <= 0) out[k] = samples_.front().frame;
        if (along[k] >= arc_length()) out[k] = samples_.back().frame;
    }
}

double Curve::turning_until(double along) const {
    if (along <= 0) return 0;
    if (along >= arc_length()) return samples_.back().turning;
    const Sample& a = samples_[sample_before(along, 0)];
    const Sample& b = *(&a + 1);
    const double span = b.along - a.along;
    return span > 0 ? a.turning + (along - a.along) / span * (b.turning - a.turning) : a.turning;
}

void Curve::face_away_from(const Vec3& center) {
    double along_normal = 0, along_binormal = 0;
    for (std::size_t i = 1; i < samples_.size(); ++i) {
        const CurveFrame& frame = samples_[i].frame;
        const Vec3 outward = frame.point - center;
        const double share = samples_[i].along - samples_[i - 1].along;
        along_normal += share * dot(outward, frame.normal);
        along_binormal += share * dot(outward, frame.binormal());
    }
    const double size = std::sqrt(along_normal * along_normal + along_binormal * along_binormal);
    if (!(size > 0)) return;
    for (Sample& sample : samples_) {
        CurveFrame& frame = sample.frame;
        frame.normal = (along_normal / size) * frame.normal + (along_binormal / size) * frame.binormal();
    }
}

}  // namespace tuftwave
