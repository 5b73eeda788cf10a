// Based on: Shimosoyama, Yamamoto, Noma. NPR Hair Modeling by Controlling the Shape of Tufts. Section 3.1 (composite
// cubic Bezier through the points). C. Yuksel, S. Schaefer, J. Keyser. Parameterization and applications of
// Catmull-Rom curves. 2011 (centripetal knots). W. Wang et al. Computation of rotation minimizing frames. 2008
// (double reflection).
// Differs: a stroke that doubles back on itself, where the tangent vanishes, gets a tight hairpin in place of a cusp.
#include "tuftwave/curve.hpp"

#include <algorithm>
#include <array>

#include "tuftwave/elementary.hpp"

namespace tuftwave {
namespace {

/// Points nearer than this share of the stroke's length to the one before are merged into it.
constexpr double kMergeShare = 1e-9;

/// Between two samples the tangent turns less than this, radians (about 11 degrees), unless the halving bottoms out.
constexpr double kSampleTurn = 0.2;
constexpr int kFirstSamples = 4;    // per Bezier segment
constexpr int kDeepestHalving = 8;  // 4 x 256 samples per segment at most

/// Cosine of the angle between a step and its first tangent, below which the step tells nothing: between two samples
/// it is 0.98 or more.
constexpr double kLeastForwards = 0.5;

/// A tangent shorter than this share of a usual one counts as vanished.
constexpr double kVanishedTangent = 1e-6;
/// Tangent of a hairpin as a share of a usual one: the turn takes about a tenth of the neighbouring segment.
constexpr double kHairpinTangent = 0.1;

/// Newton's steps towards a given arc length: three or four are usual, a vanishing tangent takes halvings.
constexpr int kMostNewtonSteps = 50;
/// Of the piece between two samples: a nanometre on a kilometre.
constexpr double kArcTolerance = 1e-12;

struct Node {
    double at, weight;
};
/// Gauss-Legendre quadrature with five nodes on [0, 1].
constexpr std::array<Node, 5> kGauss{{{0.04691007703066800, 0.11846344252809454},
                                      {0.23076534494715845, 0.23931433524968324},
                                      {0.5, 0.28444444444444444},
                                      {0.76923465505284155, 0.23931433524968324},
                                      {0.95308992296933200, 0.11846344252809454}}};

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

/// The unit normal carried from `from` to the point and tangent of `to` without spin.
Vec3 carried_normal(const CurveFrame& from, const Vec3& point, const Vec3& tangent) {
    const Vec3 v1 = point - from.point;
    const double c1 = dot(v1, v1);
    Vec3 normal = from.normal;
    // A step that does not run along the tangent is rounding, or a cusp; reflecting in it would flip the normal.
    if (dot(v1, from.tangent) > kLeastForwards * std::sqrt(c1)) {
        const Vec3 reflected_normal = normal - (2 / c1 * dot(v1, normal)) * v1;
        const Vec3 reflected_tangent = from.tangent - (2 / c1 * dot(v1, from.tangent)) * v1;
        const Vec3 v2 = tangent - reflected_tangent;
        const double c2 = dot(v2, v2);
        normal = c2 > 0 ? reflected_normal - (2 / c2 * dot(v2, reflected_normal)) * v2 : reflected_normal;
    }
    const Vec3 upright = rejected(normal, tangent);  // rounding leaves a trace of tangent
    const double size = length(upright);
    return size > 1e-6 ? upright / size : any_perpendicular(tangent);
}

}  // namespace

Vec3 Curve::Segment::point(double t) const {
    const double u = 1 - t;
    return u * u * u * b0 + 3 * u * u * t * b1 + 3 * u * t * t * b2 + t * t * t * b3;
}

Vec3 Curve::Segment::derivative(double t) const {
    const double u = 1 - t;
    return 3 * u * u * (b1 - b0) + 6 * u * t * (b2 - b1) + 3 * t * t * (b3 - b2);
}

double Curve::Segment::arc(double t0, double t1) const {
    double sum = 0;
    for (const Node& node : kGauss) sum += node.weight * length(derivative(t0 + node.at * (t1 - t0)));
    return sum * (t1 - t0);
}

double Curve::Segment::parameter(double t0, double t1, double wanted, double whole) const {
    double low = t0, high = t1, t = t0 + wanted / whole * (t1 - t0);
    for (int step = 0; step < kMostNewtonSteps; ++step) {
        const double beyond = arc(t0, t) - wanted;
        if (std::abs(beyond) <= kArcTolerance * whole) break;
        (beyond > 0 ? high : low) = t;
        const double next = t - beyond / length(derivative(t));
        t = next > low && next < high ? next : (low + high) / 2;
    }
    return t;
}

Curve::Curve(std::span<const Vec3> points) {
    make_segments(merged(points));
    for (std::size_t i = 0; i < segments_.size(); ++i) measure(i);
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
    for (int i = 0; i < kFirstSamples; ++i) sample_up_to(segment, (i + 1.0) / kFirstSamples, 0);
}

void Curve::sample_up_to(std::size_t segment, double t, int halvings) {
    const Segment& bezier = segments_[segment];
    const Sample from = samples_.back();
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
    Sample next{segment, t, from.along + bezier.arc(from_t, t), from.turning + turn, {}};
    const Vec3 point = bezier.point(t);
    next.frame = {point, tangent, carried_normal(from.frame, point, tangent)};
    samples_.push_back(next);
}

Vec3 Curve::tangent_at(std::size_t segment, double t, const Vec3& otherwise) const {
    const Vec3 derivative = segments_[segment].derivative(t);
    const double speed = length(derivative);
    return speed > 0 ? derivative / speed : otherwise;
}

std::size_t Curve::sample_before(double along) const {
    const auto after = std::upper_bound(samples_.begin() + 1, samples_.end() - 1, along,
                                        [](double value, const Sample& sample) { return value < sample.along; });
    return static_cast<std::size_t>(after - samples_.begin()) - 1;
}

CurveFrame Curve::at(double along) const {
    if (along <= 0) return samples_.front().frame;
    if (along >= arc_length()) return samples_.back().frame;
    const std::size_t index = sample_before(along);
    const Sample& a = samples_[index];
    const Sample& b = samples_[index + 1];
    const double t0 = b.segment == a.segment ? a.t : 0;
    const double span = b.along - a.along;
    if (!(span > 0)) return a.frame;
    const Segment& bezier = segments_[b.segment];

    const double t = bezier.parameter(t0, b.t, along - a.along, span);
    const Vec3 point = bezier.point(t);
    const Vec3 tangent = tangent_at(b.segment, t, a.frame.tangent);
    return {point, tangent, carried_normal(a.frame, point, tangent)};
}

double Curve::turning_until(double along) const {
    if (along <= 0) return 0;
    if (along >= arc_length()) return samples_.back().turning;
    const Sample& a = samples_[sample_before(along)];
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
