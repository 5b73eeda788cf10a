// Based on: Shimosoyama, Yamamoto, Noma. NPR Hair Modeling by Controlling the Shape of Tufts. Section 4.1, equations
// (1) to (5). Differs: beta is signed. The sum in the denominator of (5) goes on to the second tuft, since as printed
// the last tuft along lands on it. A root on the up axis has no azimuth and takes the other's.
#include "tuftwave/fill_gap.hpp"

#include <array>
#include <cmath>

#include "tuftwave/elementary.hpp"
#include "tuftwave/head.hpp"

namespace tuftwave {
namespace {

/// Tufts around a head at density 100 where the caller sets no number per metre.
constexpr double kTuftsAround = 32;

/// What is this little short of a whole tuft counts as one.
constexpr double kNearlyOne = 1e-9;

/// The way from one azimuth to another, counter-clockwise, radians in [0, 2 pi).
double counter_clockwise(double from, double to) {
    double angle = to - from;
    if (angle < 0) angle += 2 * kPi;
    return angle > 2 * kPi - kSameAngle ? 0 : angle;
}

double sweep_between(double from, double to, FillDirection direction) {
    const double left = counter_clockwise(from, to), right = counter_clockwise(to, from);
    const bool is_left =
        direction == FillDirection::kCounterClockwise || (direction == FillDirection::kShorter && left <= right);
    return is_left ? left : -right;
}

/// Equation (2).
double spherical_angle(double alpha, double beta) {
    const double angle = elementary::acos(elementary::cos(beta) * elementary::cos(alpha));
    return alpha > kPi ? 2 * kPi - angle : angle;
}

/// The length of the path of the roots on a unit sphere: azimuth and elevation grow evenly.
double path_angle(double alpha, double elevation, double beta) {
    // Gauss-Legendre with three nodes on each of 32 pieces: exact to 1e-12 for any path on a head.
    constexpr int kPieces = 32;
    struct Node {
        double at, weight;
    };
    constexpr std::array<Node, 3> kNodes{
        {{0.11270166537925831, 5.0 / 18}, {0.5, 8.0 / 18}, {0.88729833462074169, 5.0 / 18}}};
    double sum = 0;
    for (int piece = 0; piece < kPieces; ++piece) {
        for (const Node& node : kNodes) {
            const double across = alpha * elementary::cos(elevation + beta * (piece + node.at) / kPieces);
            sum += node.weight * std::sqrt(beta * beta + across * across);
        }
    }
    return sum / kPieces;
}

}  // namespace

Result<Gap> measure_gap(const Vec3& from, const Vec3& to, bool is_ring, const FillSettings& settings,
                        const Limits& limits) {
    Bearing a = bearing_of(from), b = bearing_of(to);
    if (is_vertical(from)) a.azimuth = b.azimuth;
    if (is_vertical(to)) b.azimuth = a.azimuth;

    Gap gap;
    gap.azimuth = a.azimuth;
    gap.elevation = a.elevation;
    gap.sweep = is_ring ? (settings.direction == FillDirection::kClockwise ? -2 * kPi : 2 * kPi)
                        : sweep_between(a.azimuth, b.azimuth, settings.direction);
    gap.rise = is_ring ? 0 : b.elevation - a.elevation;
    const double alpha = std::abs(gap.sweep);
    gap.gamma = settings.arc == Arc::kPath ? path_angle(alpha, gap.elevation, gap.rise)
                                           : spherical_angle(alpha, gap.rise);  // eq. (2)
    const double radius = (length(from) + length(to)) / 2;
    gap.distance = radius * gap.gamma;  // eq. (1)
    gap.tufts_per_meter = settings.tufts_per_meter.value_or(kTuftsAround / (2 * kPi * radius));
    if (!is_on(settings.density.along)) return gap;
    const double along =
        std::floor(*settings.density.along * gap.tufts_per_meter * gap.distance / 100 + kNearlyOne);  // eq. (3)
    if (along > static_cast<double>(limits.tufts))
        return Error{ErrorCode::kTooMany,
                     "/density/along",
                     along,
                     "a density that gives at most " + std::to_string(limits.tufts) + " tufts; this gives " +
                         to_text(along) + " along",
                     {},
                     static_cast<double>(limits.tufts)};
    gap.along = static_cast<std::size_t>(along);
    return gap;
}

std::vector<double> spread_along(std::size_t along, double from, double to, Spacing spacing) {
    // Diameters of tuft 0, which is the first one, to N + 1, which is the second one.
    const auto diameter = [&](std::size_t l) {
        return from + (to - from) * static_cast<double>(l) / static_cast<double>(along + 1);  // eq. (4)
    };
    std::vector<double> shares;
    shares.reserve(along + 1);
    double sum = 0;
    for (std::size_t l = 1; l <= along + 1; ++l) {
        sum += spacing == Spacing::kHalfGap ? (diameter(l - 1) + diameter(l)) / 2 : diameter(l);
        shares.push_back(sum);
    }
    const double whole = spacing == Spacing::kAsPrinted && along > 0 ? shares[along - 1] : sum;
    shares.pop_back();
    for (double& share : shares) share /= whole;  // eq. (5)
    return shares;
}

}  // namespace tuftwave
