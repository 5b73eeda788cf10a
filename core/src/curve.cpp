// Based on: Shimosoyama, Yamamoto, Noma. NPR Hair Modeling by Controlling the Shape of Tufts. Section 3.1 (composite
// cubic Bezier through the points). C. Yuksel, S. Schaefer, J. Keyser. Parameterization and applications of
// Catmull-Rom curves. 2011 (centripetal knots).
// Differs: a stroke that doubles back on itself, where the tangent vanishes, gets a tight hairpin in place of a cusp.
#include "tuftwave/curve.hpp"

#include <algorithm>
#include <array>

#include "curve_segment.hpp"
#include "place_search.hpp"

namespace tuftwave {
namespace {

/// Points nearer than this share of the stroke's length to the one before are merged into it.
constexpr double kMergeShare = 1e-9;

constexpr std::size_t kUsualSamples = 6;  // per Bezier segment

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
    kept.reserve(points.size());
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

}  // namespace

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
    PlaceSearch places;
    std::size_t before = 0;
    for (std::size_t from = 0; from < along.size(); from += pieces.size()) {
        const auto here = along.subspan(from, std::min(pieces.size(), along.size() - from));
        for (std::size_t k = 0; k < here.size(); ++k)
            pieces[k] = before = sample_before(std::clamp(here[k], 0.0, arc_length()), before);
        find(here, pieces, places);
        for (std::size_t k = 0; k < here.size(); ++k) out[from + k] = places.frame(k);
    }
}

void Curve::at_parts(std::span<const double> parts, double turn_worth, std::span<double> along,
                     const FrameRows& out) const {
    const auto measure = [&](const Sample& sample) { return sample.along + turn_worth * sample.turning; };
    const double whole = measure(samples_.back());
    std::array<std::size_t, PlaceSearch::kMost> pieces;
    PlaceSearch places;
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
        find(along.subspan(from, count), pieces, places);
        places.copy_frames(count, {out.first + from, out.stride});
    }
}

/// The pieces that places lie on.
struct Curve::Pieces {
    TUFTWAVE_BODY static void take(const Curve& curve, std::span<const double> along,
                                   std::span<const std::size_t> pieces, PlaceSearch& search) {
        const std::size_t count = along.size();
        for (std::size_t k = 0; k < count;) {
            const std::size_t piece = pieces[k];
            const Sample &a = curve.samples_[piece], &b = curve.samples_[piece + 1];
            const Segment& bezier = curve.segments_[b.segment];
            put(a, b, bezier, k, search);
            const std::size_t run_end = std::min(k + PlaceSearch::kRun, count);
            do {
                search.wanted[k] = along[k] - a.along;
                ++k;
            } while (k < run_end && pieces[k] == piece);
        }
    }

  private:
    TUFTWAVE_BODY static void put(const Sample& a, const Sample& b, const Segment& bezier, std::size_t k,
                                  PlaceSearch& search) {
        search.put(search.start, k, bezier.start);
        search.put(search.constant, k, bezier.constant);
        search.put(search.linear, k, bezier.linear);
        search.put(search.quadratic, k, bezier.quadratic);
        search.put(search.t0, k, b.from);
        search.put(search.t1, k, b.t);
        search.put(search.speed0, k, b.from_speed);
        search.put(search.speed1, k, b.speed);
        search.put(search.whole, k, b.along - a.along);
        search.put(search.point, k, a.frame.point);
        search.put(search.tangent, k, a.frame.tangent);
        search.put(search.normal, k, a.frame.normal);
    }
};

void Curve::find(std::span<const double> along, std::span<const std::size_t> pieces, PlaceSearch& search) const {
    const std::size_t count = along.size();
    run_with<Pieces::take>(vectors_, *this, along, pieces, search);
    search.find_parameters(count, vectors_);
    for (std::size_t k = 0; k < count; ++k) {
        if (search.missed[k] == 0 || !(search.whole[k] > 0)) continue;
        const Segment& bezier = segments_[samples_[pieces[k] + 1].segment];
        search.t[k] = bezier.parameter(search.t0[k], search.t1[k], search.wanted[k], search.whole[k]);
    }
    search.find_frames(count, vectors_);
    for (std::size_t k = 0; k < count; ++k) {
        if (!(search.normal_size[k] > 0)) search.normal.set(k, any_perpendicular(search.tangent[k]));
        if (!(search.whole[k] > 0)) search.set_frame(k, samples_[pieces[k]].frame);
        if (along[k] <= 0) search.set_frame(k, first());
        if (along[k] >= arc_length()) search.set_frame(k, last());
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
