// Based on: W. Wang et al. Computation of rotation minimizing frames. 2008 (double reflection). Halving where a curve
// turns quickly is our own.
#include <algorithm>
#include <array>

#include "curve_segment.hpp"
#include "place_search.hpp"
#include "tuftwave/curve.hpp"

namespace tuftwave {
namespace {

/// Between two samples the tangent turns less than this, radians (about 11 degrees), unless the halving bottoms out.
constexpr double kSampleTurn = 0.2;
constexpr std::size_t kFirstSamples = 4;  // per Bezier segment
constexpr int kDeepestHalving = 8;        // 4 x 256 samples per segment at most

constexpr double kUnknownArc = -1;  // of a piece, until all are measured at once

/// Steps from sample to sample.
struct Steps {
    static constexpr std::size_t kMost = 64;
    VectorRows<kMost + 1> points, tangents, normals;
    VectorRows<kMost> x, y, z;                          // what a normal is multiplied by to be the next one, row by row
    alignas(64) std::array<double, kMost> is_forwards;  // 0 where the step tells nothing

    TUFTWAVE_BODY static void find(Steps& s, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) {
            const bezier::Step step(s.points[k], s.tangents[k], s.points[k + 1], s.tangents[k + 1]);
            const Vec3 first = step.twice_first * step.first, second = step.twice_second * step.second,
                       through = step.second - step.coupling * step.first;
            s.x.set(k, Vec3{1, 0, 0} - first.x * step.first - second.x * through);
            s.y.set(k, Vec3{0, 1, 0} - first.y * step.first - second.y * through);
            s.z.set(k, Vec3{0, 0, 1} - first.z * step.first - second.z * through);
            s.is_forwards[k] = step.is_forwards ? 1.0 : 0.0;
        }
    }

    /// Rounding leaves a trace of the tangents in the normals.
    TUFTWAVE_BODY static void straighten_normals(Steps& s, std::size_t count) {
        for (std::size_t k = 1; k <= count; ++k) {
            const Vec3 upright = rejected(s.normals[k], s.tangents[k]);
            s.normals.set(k, 1 / length(upright) * upright);
        }
    }
};

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
    alignas(64) std::array<Row, kHalves> turns;       // from the one before, radians; not of the very first
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
        for (std::size_t k = 1; k < padded; ++k)
            s.turns[0][k] = length(s.tangents[0][k] - s.tangents[kHalves - 1][k - 1]);
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

void Curve::measure() {
    // Where two points are neighbouring doubles, the Bezier points between them coincide.
    Heading last = heading_at(0, 0, normalized(segments_[0].end - segments_[0].start));
    samples_.push_back(
        {0, 0, 0, last.speed, last.speed, 0, 0, {segments_[0].start, last.tangent, any_perpendicular(last.tangent)}});
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
        for (std::size_t k = 0; k < count; ++k) measure(from + k, first, k, last);
    }
    find_unknown_arcs();
    double along = 0, turning = 0;  // so far each sample has no more than its own piece's
    for (Sample& sample : samples_) {
        sample.along = along += sample.along;
        sample.turning = turning += sample.turning;
    }
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

inline void Curve::add_sample(std::size_t segment, double from, double t, const Heading& end, double arc, double turn,
                              Heading& last) {
    const Segment& bezier = segments_[segment];
    const double from_speed = from > 0 ? last.speed : length(bezier.constant);
    samples_.push_back({segment, from, t, from_speed, end.speed, arc, turn, {bezier.point(t), end.tangent, {}}});
    last = end;
}

void Curve::measure(std::size_t segment, const FirstSamples& first, std::size_t k, Heading& last) {
    for (std::size_t piece = 0; piece < kFirstSamples; ++piece) {
        const double from = static_cast<double>(piece) / kFirstSamples, t = from + 1.0 / kFirstSamples;
        const std::size_t half = 2 * piece, whole = half + 1;
        const Vec3 middle = first.tangents[half][k];
        const double turn =
            (k == 0 && piece == 0 ? length(middle - last.tangent) : first.turns[half][k]) + first.turns[whole][k];
        const Heading end{first.tangents[whole][k], first.speeds[whole][k]};
        if (turn <= kSampleTurn) {
            add_sample(segment, from, t, end, first.arcs[piece][k], turn, last);
            continue;
        }
        const double speed = first.speeds[half][k];
        sample_up_to(segment, from, t, {speed > 0 ? middle : last.tangent, speed},
                     {end.speed > 0 ? end.tangent : last.tangent, end.speed}, 0, last);
    }
}

void Curve::sample_up_to(std::size_t segment, double from, double t, const Heading& between, const Heading& end,
                         int halvings, Heading& last) {
    const Vec3 start = last.tangent;
    const double turn = length(between.tangent - start) + length(end.tangent - between.tangent);
    if (turn > kSampleTurn && halvings < kDeepestHalving) {
        const double middle = (from + t) / 2;
        const Heading before = heading_at(segment, (from + middle) / 2, start),
                      after = heading_at(segment, (middle + t) / 2, between.tangent);
        sample_up_to(segment, from, middle, before, between, halvings + 1, last);
        sample_up_to(segment, middle, t, after, end, halvings + 1, last);
        return;
    }
    add_sample(segment, from, t, end, kUnknownArc, turn, last);
}

void Curve::carry_normals() {
    Steps steps;
    for (std::size_t start = 0; start + 1 < samples_.size(); start += Steps::kMost) {
        Sample* const samples = &samples_[start];
        const std::size_t count = std::min(Steps::kMost, samples_.size() - start - 1);
        for (std::size_t k = 0; k <= count; ++k) {
            steps.points.set(k, samples[k].frame.point);
            steps.tangents.set(k, samples[k].frame.tangent);
        }
        run_with<Steps::find>(vectors_, steps, count);
        Vec3 normal = samples[0].frame.normal;
        for (std::size_t k = 0; k < count; ++k) {
            if (steps.is_forwards[k] != 0) {
                normal = {dot(steps.x[k], normal), dot(steps.y[k], normal), dot(steps.z[k], normal)};
            } else {
                const Vec3& tangent = samples[k + 1].frame.tangent;
                const Vec3 upright = rejected(normal, tangent);
                const double size = length(upright);
                normal = size > bezier::kLeastNormal ? upright / size : any_perpendicular(tangent);
            }
            steps.normals.set(k + 1, normal);
        }
        run_with<Steps::straighten_normals>(vectors_, steps, count);
        for (std::size_t k = 1; k <= count; ++k) samples[k].frame.normal = steps.normals[k];
    }
}

Curve::Heading Curve::heading_at(std::size_t segment, double t, const Vec3& otherwise) const {
    const Vec3 velocity = segments_[segment].velocity().at(t);
    const double speed = length(velocity);
    return {speed > 0 ? velocity / speed : otherwise, speed};
}

}  // namespace tuftwave
