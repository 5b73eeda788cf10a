// Based on: K. Furukawa, S. Nakata, 2018, equation (1) and section 2, discretisation in space; see motion.cpp, whose
// poses these are, seen in their plane.
#include <array>
#include <cmath>
#include <cstddef>

#include "fit_refine.hpp"
#include "tuftwave/elementary.hpp"

namespace tuftwave {
namespace {

/// A number and how it changes with each unknown.
struct Varied {
    double value = 0;
    std::array<double, 5> by{};

    void add(const Varied& other, double times) {
        value += times * other.value;
        for (std::size_t j = 0; j < by.size(); ++j) by[j] += times * other.by[j];
    }
};

/// What of the wave does not change from picture to picture, at one node.
struct NodeWave {
    double x = 0, envelope = 0, log_share = 0;
    elementary::SinCos turn{};  // of q x
};

std::vector<NodeWave> node_waves(const DrawnPlane& plane, const WaveUnknowns& unknowns) {
    std::vector<NodeWave> nodes;
    for (const double x : plane.x) {
        const double share = x / kPi, log_share = share > 0 ? elementary::log(share) : 0;
        nodes.push_back(
            {x, elementary::pow(share, unknowns[kExponent]), log_share, elementary::sincos(unknowns[kWaveNumber] * x)});
    }
    return nodes;
}

/// The height of the hair line at a node, eq. (1).
Varied height_at(const NodeWave& node, const elementary::SinCos& phase, const WaveUnknowns& unknowns) {
    const double c = node.turn.cos * phase.cos + node.turn.sin * phase.sin;  // cos(q x - psi)
    const double s = node.turn.sin * phase.cos - node.turn.cos * phase.sin;
    const double e = -node.envelope;
    Varied height;
    height.value = e * (unknowns[kCosine] * c + unknowns[kSine] * s + unknowns[kDroop]);
    height.by = {e * c, e * s, e, e * node.x * (unknowns[kSine] * c - unknowns[kCosine] * s),
                 node.log_share * height.value};
    return height;
}

/// The angles of the chords: picture n, bone i at [n * bones + i].
std::vector<Varied> chord_angles(const DrawnPlane& plane, const WaveUnknowns& unknowns) {
    const std::vector<NodeWave> nodes = node_waves(plane, unknowns);
    std::vector<Varied> angles;
    angles.reserve(plane.nodes.size());
    for (const double psi : plane.phases) {
        const elementary::SinCos phase = elementary::sincos(psi);
        Varied from = height_at(nodes[0], phase, unknowns);
        for (std::size_t i = 0; i < plane.bones(); ++i) {
            const Varied to = height_at(nodes[i + 1], phase, unknowns);
            const double run = plane.x[i + 1] - plane.x[i], rise = to.value - from.value;
            Varied angle{elementary::atan2(rise, run), {}};
            const double per_rise = run > 0 ? run / (run * run + rise * rise) : 0;
            for (std::size_t j = 0; j < angle.by.size(); ++j) angle.by[j] = per_rise * (to.by[j] - from.by[j]);
            angles.push_back(angle);
            from = to;
        }
    }
    return angles;
}

/// Takes each bone's mean over the pictures out.
void center(std::vector<Varied>& angles, std::size_t bones) {
    const double share = static_cast<double>(bones) / static_cast<double>(angles.size());
    for (std::size_t bone = 0; bone < bones; ++bone) {
        Varied mean;
        for (std::size_t at = bone; at < angles.size(); at += bones) mean.add(angles[at], share);
        for (std::size_t at = bone; at < angles.size(); at += bones) angles[at].add(mean, -1);
    }
}

/// Where the droop hangs on the swing, B = A / s, it is no unknown of its own.
void tie_droop(std::vector<Varied>& angles, const WaveUnknowns& unknowns, double lightness) {
    const double swing = swing_of(unknowns);
    const double by_cosine = swing > 0 ? unknowns[kCosine] / swing / lightness : 0;
    const double by_sine = swing > 0 ? unknowns[kSine] / swing / lightness : 0;
    for (Varied& angle : angles) {
        angle.by[kCosine] += by_cosine * angle.by[kDroop];
        angle.by[kSine] += by_sine * angle.by[kDroop];
        angle.by[kDroop] = 0;
    }
}

/// `arm` turned by `angle`.
std::array<Varied, 2> turned(const PlanePoint& arm, const Varied& angle) {
    const auto [sine, cosine] = elementary::sincos(angle.value);
    std::array<Varied, 2> end;
    end[0].value = cosine * arm.along - sine * arm.across;
    end[1].value = sine * arm.along + cosine * arm.across;
    end[0].add({0, angle.by}, -end[1].value);
    end[1].add({0, angle.by}, end[0].value);
    return end;
}

}  // namespace

Misfit measure_misfit(const DrawnPlane& plane, const WaveUnknowns& unknowns, std::optional<double> lightness) {
    std::vector<Varied> angles = chord_angles(plane, unknowns);
    if (plane.is_centered) center(angles, plane.bones());
    if (lightness) tie_droop(angles, unknowns, *lightness);
    Misfit misfit;
    for (std::size_t n = 0; n < plane.pictures(); ++n) {
        std::array<Varied, 2> node;
        for (std::size_t i = 0; i < plane.bones(); ++i) {
            const std::size_t at = n * plane.bones() + i;
            const std::array<Varied, 2> bone = turned(plane.arms[i], angles[at]);
            const double drawn[] = {plane.nodes[at].along, plane.nodes[at].across};
            for (std::size_t axis = 0; axis < 2; ++axis) {
                node[axis].add(bone[axis], 1);
                const double missing = drawn[axis] - node[axis].value;
                misfit.cost += missing * missing;
                misfit.equations.add(node[axis].by, missing);
            }
        }
    }
    return misfit;
}

}  // namespace tuftwave
