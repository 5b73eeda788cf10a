// Based on: our own choice; the paper fits by eye. The plane is the one in which laying.cpp turns bones.
#include "drawn_plane.hpp"

#include "laying.hpp"
#include "tuftwave/elementary.hpp"
#include "tuftwave/vector_checks.hpp"

namespace tuftwave {
namespace {

/// Rounds of finding the rest pose: each needs the axis, which needs the rest pose. Flat drawings need one.
constexpr int kRestRounds = 30;

Motion motion_of(const FitSettings& settings) {
    Motion motion;
    motion.mode = settings.mode;
    motion.wind = settings.wind;
    motion.up = settings.up;
    return motion;
}

Vec3 axis_of(const Line& rest, const FitSettings& settings) {
    Chain chain;
    chain.nodes = rest;
    return Laying(chain, motion_of(settings)).axis();
}

/// Axes in the plane across `axis`: the first as near to `along` as can be, the second a quarter turn further.
struct PlaneAxes {
    Vec3 first, second;

    PlaneAxes(const Vec3& axis, const Vec3& along) {
        const Vec3 across = rejected(along, axis);
        first = length(across) > kSmallestSine ? normalized(across) : any_perpendicular(axis);
        second = cross(axis, first);
    }
    PlanePoint of(const Vec3& v) const { return {dot(v, first), dot(v, second)}; }
};

/// The angle from `from` to `to` about the axis, radians.
double angle_between(const PlanePoint& from, const PlanePoint& to) {
    return elementary::atan2(from.along * to.across - from.across * to.along,
                             from.along * to.along + from.across * to.across);
}

/// Each segment's mean direction over the pictures, longer where the pictures agree; where they cancel out, the first
/// picture's.
std::vector<Vec3> mean_segments(const std::vector<Line>& pictures) {
    std::vector<Vec3> means(pictures.front().size() - 1);
    for (std::size_t i = 0; i < means.size(); ++i) {
        for (const Line& line : pictures) means[i] = means[i] + (line[i + 1] - line[i]);
        if (length(means[i]) == 0) means[i] = pictures.front()[i + 1] - pictures.front()[i];
    }
    return means;
}

Line line_of(const Vec3& root, const std::vector<Vec3>& directions, const std::vector<double>& lengths) {
    Line line{root};
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const double size = length(directions[i]);
        line.push_back(size > 0 ? line.back() + lengths[i] / size * directions[i] : line.back());
    }
    return line;
}

/// The direction of segment `i` about which its drawn angles have the mean zero.
Vec3 centered_direction(const std::vector<Line>& pictures, std::size_t i, const Vec3& guess, const Vec3& axis) {
    const PlaneAxes plane(axis, guess);
    const PlanePoint zero = plane.of(guess);
    const auto count = static_cast<double>(pictures.size());
    double angle = 0, out_of_plane = 0;
    for (const Line& line : pictures) {
        const Vec3 segment = line[i + 1] - line[i];
        angle += angle_between(zero, plane.of(segment)) / count;
        if (length(segment) > 0) out_of_plane += dot(normalized(segment), axis) / count;
    }
    const double in_plane = std::sqrt(out_of_plane * out_of_plane < 1 ? 1 - out_of_plane * out_of_plane : 0.0);
    return in_plane * rotated(turn_about(axis, angle), plane.first) + out_of_plane * axis;
}

/// The pose about which the pictures swing evenly, which is what a motion without droop is added to.
Line centered_rest(const std::vector<Line>& pictures, const std::vector<double>& lengths, const FitSettings& settings) {
    std::vector<Vec3> directions = mean_segments(pictures);
    Line rest = line_of(pictures.front().front(), directions, lengths);
    Vec3 axis = axis_of(rest, settings);
    for (int round = 0; round < kRestRounds; ++round) {
        for (std::size_t i = 0; i < directions.size(); ++i)
            directions[i] = centered_direction(pictures, i, directions[i], axis);
        rest = line_of(rest.front(), directions, lengths);
        const Vec3 next = axis_of(rest, settings);
        const bool is_settled = next == axis;
        axis = next;
        if (is_settled) break;
    }
    return rest;
}

Line rest_of(const Drawing& drawing, const FitSettings& settings) {
    if (drawing.rest) return *drawing.rest;
    const std::vector<double> lengths = segment_lengths(drawing.pictures);
    if (settings.mode == Mode::kRelative) return centered_rest(drawing.pictures, lengths, settings);
    return line_of(drawing.pictures.front().front(), std::vector<Vec3>(lengths.size(), settings.wind), lengths);
}

}  // namespace

std::vector<double> segment_lengths(const std::vector<Line>& pictures) {
    std::vector<double> lengths(pictures.front().size() - 1);
    for (const Line& line : pictures) {
        for (std::size_t i = 0; i < lengths.size(); ++i)
            lengths[i] += length(line[i + 1] - line[i]) / static_cast<double>(pictures.size());
    }
    return lengths;
}

DrawnPlane::DrawnPlane(const Drawing& drawing, const FitSettings& settings, const Schedule& schedule, int cycles)
    : rest(rest_of(drawing, settings)), is_centered(settings.mode == Mode::kRelative) {
    const std::vector<double> lengths = segment_lengths({rest});
    x.push_back(0);
    for (const double bone : lengths) x.push_back(x.back() + bone);
    rest_length = x.back();
    for (double& at : x) at *= kPi / rest_length;
    x.back() = kPi;

    const PlaneAxes plane(axis_of(rest, settings), settings.wind);
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const Vec3 arm = is_centered ? rest[i + 1] - rest[i] : lengths[i] * plane.first;
        arms.push_back(plane.of(arm / rest_length));
    }
    for (std::size_t n = 0; n < drawing.pictures.size(); ++n) {
        const Line& line = drawing.pictures[n];
        phases.push_back(picture_phase(schedule, static_cast<int>(n), cycles));
        for (std::size_t i = 1; i < line.size(); ++i) nodes.push_back(plane.of((line[i] - line[0]) / rest_length));
    }
}

}  // namespace tuftwave
