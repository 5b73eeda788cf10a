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

/// The centripetal Catmull-Rom tangent at `b`, per unit of knot distance. @param d1, d2  knot distances before and
/// after
Vec3 centripetal_tangent(const Vec3& a, const Vec3& b, const Vec3& c, double d1, double d2) {
    const Vec3 tangent = (b - a) / d1 - (c - a) / (d1 + d2) + (c - b) / d2;
    const double usual = std::min(d1, d2);
    if (length(tangent) > kVanishedTangent * usual) return tangent;
    return kHairpinTangent * usual * any_perpendicular(normalized(b - a));
}

/// Steps from sample to sample, each as two reflections, which do not depend on the normal that they carry.
struct Reflections {
    static constexpr std::size_t kMost = 64;
    VectorRows<kMost> first, second;                    // what is reflected in
    alignas(64) std::array<double, kMost> twice_first;  // 2 / its square; 0 reflects nothing
    alignas(64) std::array<double, kMost> twice_second;
    alignas(64) std::array<double, kMost> forwards;  // 0 where the step tells nothing
    VectorRows<kMost> normals;
};

template <class Sample>
TUFTWAVE_BODY void find_reflections(const Sample* samples, std::size_t count, Reflections& to) {
    for (std::size_t k = 0; k < count; ++k) {
        const CurveFrame &from = samples[k].frame, &next = samples[k + 1].frame;
        const bezier::Step step(from.point, from.tangent, next.point, next.tangent);
        to.first.set(k, step.first);
        to.second.set(k, step.second);
        to.twice_first[k] = step.twice_first;
        to.twice_second[k] = step.twice_second;
        to.forwards[k] = step.is_forwards ? 1.0 : 0.0;
    }
}

template <class Sample>
TUFTWAVE_BODY void set_normals(Sample* samples, std::size_t count, const Reflections& from) {
    for (std::size_t k = 0; k < count; ++k) {
        CurveFrame& frame = samples[k + 1].frame;
        const Vec3 upright = rejected(from.normals[k], frame.tangent);  // rounding leaves a trace of tangent
        const double size = length(upright);
        frame.normal = upright / size;
    }
}

/// What the samples of one segment are made of, before anything is known to turn too quickly: tangents at their ends
/// and halfway between, and the length from one to the next.
struct FirstSamples {
    static constexpr std::size_t kHalves = 2 * kFirstSamples;
    VectorRows<kHalves> velocities;
    alignas(64) std::array<double, kHalves> speeds;
    alignas(64) std::array<double, kFirstSamples> arcs;
};

TUFTWAVE_BODY void take_first_samples(const bezier::Hodograph& curve, FirstSamples& out) {
    for (std::size_t k = 0; k < FirstSamples::kHalves; ++k) {
        const Vec3 velocity = curve.derivative(static_cast<double>(k + 1) / FirstSamples::kHalves);
        out.velocities.set(k, velocity);
        out.speeds[k] = length(velocity);
    }
    for (std::size_t k = 0; k < kFirstSamples; ++k)
        out.arcs[k] = curve.arc(static_cast<double>(k) / kFirstSamples, static_cast<double>(k + 1) / kFirstSamples);
}

}  // namespace

Vec3 Curve::Segment::point(double t) const { return bezier::point(b0, b1, b2, b3, t); }

bezier::Hodograph Curve::Segment::hodograph() const { return {b1 - b0, b2 - b1, b3 - b2}; }

double Curve::Segment::parameter(double t0, double t1, double wanted, double whole) const {
    const bezier::Hodograph curve = hodograph();
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
    for (std::size_t i = 0; i < segments_.size(); ++i) measure(i);
    carry_normals();
}

void Curve::make_segments(std::span<const Vec3> p) {
    const std::size_t last = p.size() - 1;
    const auto knot = [&](std::size_t i) { return std::sqrt(length(p[i + 1] - p[i])); };
    // A phantom point mirrored at each end makes the end tangent the chord.
    Vec3 tangent = (p[1] - p[0]) / knot(0);
    segments_.reserve(last);
    for (std::size_t i = 0; i < last; ++i) {
        const double d = knot(i);
        const Vec3 next =
            i + 1 < last ? centripetal_tangent(p[i], p[i + 1], p[i + 2], d, knot(i + 1)) : (p[last] - p[last - 1]) / d;
        segments_.push_back({p[i], p[i] + d / 3 * tangent, p[i + 1] - d / 3 * next, p[i + 1]});
        tangent = next;
    }
}

void Curve::measure(std::size_t segment) {
    if (samples_.empty()) {
        // Where two points are neighbouring doubles, the Bezier points between them coincide.
        const Vec3 tangent = tangent_at(0, 0, normalized(segments_[0].b3 - segments_[0].b0));
        samples_.push_back({0, 0, 0, 0, {segments_[0].b0, tangent, any_perpendicular(tangent)}});
    }
    FirstSamples first;
    run_with<take_first_samples>(vectors_, segments_[segment].hodograph(), first);
    for (std::size_t k = 0; k < kFirstSamples; ++k) {
        const double t = static_cast<double>(k + 1) / kFirstSamples;
        const Vec3& last = samples_.back().frame.tangent;
        const auto tangent = [&](std::size_t half) {
            return first.speeds[half] > 0 ? first.velocities[half] / first.speeds[half] : last;
        };
        const Vec3 between = tangent(2 * k), end = tangent(2 * k + 1);
        const double turn = length(between - last) + length(end - between);
        if (turn > kSampleTurn) {
            sample_up_to(segment, t, 0);
        } else {
            add_sample(segment, t, first.arcs[k], turn, end);
        }
    }
}

void Curve::sample_up_to(std::size_t segment, double t, int halvings) {
    const Sample& from = samples_.back();
    const double from_t = from.segment == segment ? from.t : 0;
    const double middle = (from_t + t) / 2;
    const Vec3 tangent = tangent_at(segment, t, from.frame.tangent);
    const Vec3 tangent_between = tangent_at(segment, middle, from.frame.tangent);
    const double turn = length(tangent_between - from.frame.tangent) + length(tangent - tangent_between);
    if (turn > kSampleTurn && halvings < kDeepestHalving) {
        sample_up_to(segment, middle, halvings + 1);
        sample_up_to(segment, t, halvings + 1);
        return;
    }
    add_sample(segment, t, segments_[segment].hodograph().arc(from_t, t), turn, tangent);
}

void Curve::add_sample(std::size_t segment, double t, double arc, double turn, const Vec3& tangent) {
    const Sample& from = samples_.back();
    const Vec3 point = segments_[segment].point(t);
    samples_.push_back({segment, t, from.along + arc, from.turning + turn, {point, tangent, {}}});
}

void Curve::carry_normals() {
    Reflections steps;
    Vec3 normal = samples_.front().frame.normal;
    for (std::size_t start = 0; start + 1 < samples_.size(); start += Reflections::kMost) {
        Sample* const samples = &samples_[start];
        const std::size_t count = std::min(Reflections::kMost, samples_.size() - 1 - start);
        run_with<find_reflections<Sample>>(vectors_, samples, count, steps);
        for (std::size_t k = 0; k < count; ++k) {
            if (steps.forwards[k] != 0) {
                normal = bezier::reflected(normal, steps.first[k], steps.twice_first[k]);
                normal = bezier::reflected(normal, steps.second[k], steps.twice_second[k]);
            } else {
                const Vec3& tangent = samples[k + 1].frame.tangent;
                const Vec3 upright = rejected(normal, tangent);
                const double size = length(upright);
                normal = size > bezier::kLeastNormal ? upright / size : any_perpendicular(tangent);
            }
            steps.normals.set(k, normal);
        }
        run_with<set_normals<Sample>>(vectors_, samples, count, steps);
        normal = samples[count].frame.normal;
    }
}

Vec3 Curve::tangent_at(std::size_t segment, double t, const Vec3& otherwise) const {
    const Vec3 derivative = segments_[segment].hodograph().derivative(t);
    const double speed = length(derivative);
    return speed > 0 ? derivative / speed : otherwise;
}

std::size_t Curve::sample_before(double along, std::size_t guess) const {
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
    PlaceSearch search;
    for (std::size_t from = 0; from < along.size(); from += PlaceSearch::kMost) {
        const std::size_t count = std::min(PlaceSearch::kMost, along.size() - from);
        find(along.subspan(from, count), out.subspan(from, count), search);
    }
}

void Curve::find(std::span<const double> along, std::span<CurveFrame> out, PlaceSearch& search) const {
    const std::size_t count = along.size();
    std::array<std::size_t, PlaceSearch::kMost> samples;
    std::size_t before = 0;
    for (std::size_t k = 0; k < count; ++k) {
        before = sample_before(std::clamp(along[k], 0.0, arc_length()), before);
        const Sample& a = samples_[before];
        const Sample& b = samples_[before + 1];
        const Segment& bezier = segments_[b.segment];
        samples[k] = before;
        search.b0.set(k, bezier.b0);
        search.b1.set(k, bezier.b1);
        search.b2.set(k, bezier.b2);
        search.b3.set(k, bezier.b3);
        search.t0[k] = b.segment == a.segment ? a.t : 0;
        search.t1[k] = b.t;
        search.wanted[k] = along[k] - a.along;
        search.whole[k] = b.along - a.along;
        search.point.set(k, a.frame.point);
        search.tangent.set(k, a.frame.tangent);
        search.normal.set(k, a.frame.normal);
    }
    search.find_parameters(count, vectors_);
    for (std::size_t k = 0; k < count; ++k) {
        if (search.missed[k] == 0 || !(search.whole[k] > 0)) continue;
        const Segment& bezier = segments_[samples_[samples[k] + 1].segment];
        search.t[k] = bezier.parameter(search.t0[k], search.t1[k], search.wanted[k], search.whole[k]);
    }
    search.find_frames(count, vectors_);
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 tangent = search.tangent[k];
        out[k] = {search.point[k], tangent, search.normal_size[k] > 0 ? search.normal[k] : any_perpendicular(tangent)};
        if (!(search.whole[k] > 0)) out[k] = samples_[samples[k]].frame;
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

double Curve::along_at(double part, double turn_worth) const {
    const auto measure = [&](const Sample& sample) { return sample.along + turn_worth * sample.turning; };
    const double wanted = part * measure(samples_.back());
    const auto after = std::lower_bound(samples_.begin() + 1, samples_.end() - 1, wanted,
                                        [&](const Sample& sample, double value) { return measure(sample) < value; });
    const Sample& a = *(after - 1);
    const Sample& b = *after;
    const double span = measure(b) - measure(a);
    return span > 0 ? a.along + std::clamp((wanted - measure(a)) / span, 0.0, 1.0) * (b.along - a.along) : a.along;
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
