// Based on: Furukawa, Nakata. Automatic Generation of the Periodic Hair Motion of 3D Characters for Anime Production.
// 2018. Section 3, Table 1.
// Differs: the paper does not say how its errors are averaged; here every segment and every node but the root counts
// the same.
#include "tuftwave/measure.hpp"

#include <cstddef>
#include <string>

#include "tuftwave/elementary.hpp"
#include "tuftwave/vector_checks.hpp"

namespace tuftwave {
namespace {

double angle_between(const Vec3& a, const Vec3& b) { return elementary::atan2(length(cross(a, b)), dot(a, b)); }

LineError line_error(const Line& line, const Line& reference, double rest_length) {
    LineError error;
    for (std::size_t i = 1; i < line.size(); ++i) {
        error.angle += angle_between(line[i] - line[i - 1], reference[i] - reference[i - 1]);
        error.position += length((line[i] - line[0]) - (reference[i] - reference[0]));
    }
    const auto segments = static_cast<double>(line.size() - 1);
    return {error.angle / segments, error.position / segments / rest_length};
}

Error unequal(const std::string& field, std::size_t given, std::size_t wanted, const std::string& what) {
    const auto count = static_cast<double>(wanted);
    return {ErrorCode::kConflict,
            field,
            static_cast<double>(given),
            "as many " + what + " as the reference has, " + to_text(count),
            count,
            count};
}

/// Node by node the mean over the pictures, from the root.
Line mean_line(std::span<const Line> lines) {
    Line mean(lines.front().size());
    for (const Line& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) mean[i] = mean[i] + (line[i] - line[0]);
    }
    for (Vec3& node : mean) node = node / static_cast<double>(lines.size());
    return mean;
}

}  // namespace

Check check_lines(std::span<const Line> lines, const Limits& limits) {
    if (Check wrong = check_count(lines.size(), 1, limits.pictures, "")) return wrong;
    for (std::size_t n = 0; n < lines.size(); ++n) {
        const std::string place = "/" + std::to_string(n);
        if (Check wrong = check_count(lines[n].size(), 2, limits.nodes_per_chain, place)) return wrong;
        if (lines[n].size() != lines[0].size())
            return Error{ErrorCode::kConflict,
                         place,
                         static_cast<double>(lines[n].size()),
                         "as many nodes as the first picture has",
                         {},
                         {}};
        if (Check wrong = check_positions(lines[n], limits, place)) return wrong;
    }
    return {};
}

Result<MotionError> measure_error(std::span<const Line> lines, std::span<const Line> reference, double rest_length) {
    if (lines.size() != reference.size()) return unequal("", lines.size(), reference.size(), "pictures");
    MotionError error;
    for (std::size_t n = 0; n < lines.size(); ++n) {
        if (lines[n].size() != reference[n].size())
            return unequal("/" + std::to_string(n), lines[n].size(), reference[n].size(), "nodes");
        error.pictures.push_back(line_error(lines[n], reference[n], rest_length));
        error.mean.angle += error.pictures.back().angle / static_cast<double>(lines.size());
        error.mean.position += error.pictures.back().position / static_cast<double>(lines.size());
    }
    return error;
}

LineError error_in_all(std::span<const MotionError> chains, std::span<const std::size_t> segments) {
    LineError sum;
    double whole = 0;
    for (std::size_t i = 0; i < chains.size(); ++i) {
        const double weight = static_cast<double>(segments[i]) * static_cast<double>(chains[i].pictures.size());
        sum.angle += weight * chains[i].mean.angle;
        sum.position += weight * chains[i].mean.position;
        whole += weight;
    }
    return {sum.angle / whole, sum.position / whole};
}

double mean_length(std::span<const Line> lines) {
    double whole = 0;
    for (const Line& line : lines) {
        for (std::size_t i = 1; i < line.size(); ++i) whole += length(line[i] - line[i - 1]);
    }
    return whole / static_cast<double>(lines.size());
}

MotionError still_error(std::span<const Line> reference, double rest_length) {
    const std::vector<Line> still(reference.size(), mean_line(reference));
    return *measure_error(still, reference, rest_length);
}

}  // namespace tuftwave
