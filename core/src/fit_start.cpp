// Based on: K. Furukawa, S. Nakata, 2018, equation (1), which is linear in three of its five unknowns.
// Differs: the paper finds its waves by eye.
#include "fit_start.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "normal_equations.hpp"
#include "tuftwave/elementary.hpp"

namespace tuftwave {
namespace {

constexpr double kWaveNumberStep = 0.25;  // half a step turns the tip's phase by 22 degrees
constexpr int kExponents = 14;            // from the least to the most, each 1.5 times the one before
constexpr std::size_t kStartsEachWay = 3;
constexpr double kSteepest = 1.4;  // radians, 80 degrees: beyond it slopes say more about noise than about the wave
constexpr double kRidge = 1e-10;   // of the diagonal, so that what is not determined is zero

/// Sums over the pictures of one bone's weights w and slopes y, times the phases' cosines c and sines s: all that the
/// linear solve needs of them, whatever the wave.
struct BoneMoments {
    double w = 0, wc = 0, ws = 0, wcc = 0, wcs = 0, wss = 0, wy = 0, wyc = 0, wys = 0, wyy = 0;
};

double wrapped(double angle) {
    if (angle > kPi) return angle - 2 * kPi;
    return angle < -kPi ? angle + 2 * kPi : angle;
}

/// How far bone `i` is turned in picture `n`, radians in [-pi, pi].
double drawn_angle(const DrawnPlane& plane, std::size_t n, std::size_t i) {
    const std::size_t at = n * plane.bones() + i;
    const PlanePoint from = i == 0 ? PlanePoint{} : plane.nodes[at - 1], to = plane.nodes[at], arm = plane.arms[i];
    return wrapped(elementary::atan2(to.across - from.across, to.along - from.along) -
                   elementary::atan2(arm.across, arm.along));
}

std::vector<BoneMoments> moments_of(const DrawnPlane& plane) {
    std::vector<BoneMoments> moments(plane.bones());
    for (std::size_t i = 0; i < plane.bones(); ++i) {
        // A turn moves the nodes beyond it by the arm's length.
        const PlanePoint arm = plane.arms[i];
        const double moved = (arm.along * arm.along + arm.across * arm.across) * static_cast<double>(plane.bones() - i);
        for (std::size_t n = 0; n < plane.pictures(); ++n) {
            const double angle = std::clamp(drawn_angle(plane, n, i), -kSteepest, kSteepest);
            const auto [sine, cosine] = elementary::sincos(angle);
            const auto [s, c] = elementary::sincos(plane.phases[n]);
            const double y = sine / cosine, w = moved * cosine * cosine * cosine * cosine;  // d angle = cos^2 d slope
            BoneMoments& sum = moments[i];
            sum.w += w, sum.wc += w * c, sum.ws += w * s;
            sum.wcc += w * c * c, sum.wcs += w * c * s, sum.wss += w * s * s;
            sum.wy += w * y, sum.wyc += w * y * c, sum.wys += w * y * s, sum.wyy += w * y * y;
        }
    }
    return moments;
}

/// Adds one bone's slopes to the normal equations of C, S and B. Its slope is -(C (u c + v s) + S (v c - u s) + B d).
void add_bone(NormalEquations<3>& equations, const BoneMoments& sum, double u, double v, double d) {
    auto& matrix = equations.matrix;
    matrix[0][0] += u * u * sum.wcc + 2 * u * v * sum.wcs + v * v * sum.wss;
    matrix[1][0] += u * v * (sum.wcc - sum.wss) + (v * v - u * u) * sum.wcs;
    matrix[1][1] += v * v * sum.wcc - 2 * u * v * sum.wcs + u * u * sum.wss;
    matrix[2][0] += d * (u * sum.wc + v * sum.ws);
    matrix[2][1] += d * (v * sum.wc - u * sum.ws);
    matrix[2][2] += d * d * sum.w;
    equations.right[0] -= u * sum.wyc + v * sum.wys;
    equations.right[1] -= v * sum.wyc - u * sum.wys;
    equations.right[2] -= d * sum.wy;
}

struct Start {
    WaveUnknowns unknowns{};
    double cost = 0;
};

/// Waves at the points of the grid.
class Grid {
  public:
    Grid(const DrawnPlane& plane, const WaveBounds& bounds) : plane_(plane), moments_(moments_of(plane)) {
        const double ratio = bounds.exponent.maximum / bounds.exponent.minimum;
        for (int j = 0; j < kExponents; ++j) {
            const double p = bounds.exponent.minimum * elementary::pow(ratio, j / (kExponents - 1.0));
            exponents_.push_back(std::clamp(p, bounds.exponent.minimum, bounds.exponent.maximum));
            for (const double x : plane.x) envelopes_.push_back(elementary::pow(x / kPi, exponents_.back()));
        }
        for (const BoneMoments& bone : moments_) drawn_ += bone.wyy;
    }

    /// The best wave of this wave number.
    Start best(double wave_number) const {
        std::vector<elementary::SinCos> turns;
        for (const double x : plane_.x) turns.push_back(elementary::sincos(wave_number * x));
        Start best;
        for (std::size_t j = 0; j < exponents_.size(); ++j) {
            const Start start = solve(wave_number, j, turns);
            if (j == 0 || start.cost < best.cost) best = start;
        }
        return best;
    }

  private:
    Start solve(double wave_number, std::size_t j, const std::vector<elementary::SinCos>& turns) const {
        NormalEquations<3> equations;
        const std::size_t first = j * plane_.x.size();
        for (std::size_t i = 0; i < plane_.bones(); ++i) {
            const double run = plane_.x[i + 1] - plane_.x[i];
            if (!(run > 0)) continue;
            const double from = envelopes_[first + i], to = envelopes_[first + i + 1];
            add_bone(equations, moments_[i], (to * turns[i + 1].cos - from * turns[i].cos) / run,
                     (to * turns[i + 1].sin - from * turns[i].sin) / run, (to - from) / run);
        }
        if (plane_.is_centered) equations.hold(kDroop);  // to first order, taking out the mean takes out the droop
        const std::array<double, 3> right = equations.right;
        for (std::size_t i = 0; i < 3; ++i) equations.matrix[i][i] = equations.matrix[i][i] * (1 + kRidge) + 1e-300;
        const auto solved = equations.solve();
        if (!solved) return {{0, 0, 0, wave_number, exponents_[j]}, drawn_};
        const auto [c, s, b] = *solved;
        return {{c, s, b, wave_number, exponents_[j]}, drawn_ - c * right[0] - s * right[1] - b * right[2]};
    }

    const DrawnPlane& plane_;
    std::vector<BoneMoments> moments_;
    std::vector<double> exponents_, envelopes_;
    double drawn_ = 0;
};

/// The least of each dip in the row, best first, at most kStartsEachWay.
std::vector<Start> dips(const std::vector<Start>& row) {
    std::vector<Start> found;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const bool falls = i == 0 || row[i].cost < row[i - 1].cost;
        const bool rises = i + 1 == row.size() || row[i].cost <= row[i + 1].cost;
        if (falls && rises) found.push_back(row[i]);
    }
    std::stable_sort(found.begin(), found.end(), [](const Start& a, const Start& b) { return a.cost < b.cost; });
    if (found.size() > kStartsEachWay) found.resize(kStartsEachWay);
    return found;
}

}  // namespace

std::vector<WaveUnknowns> likely_waves(const DrawnPlane& plane, const WaveBounds& bounds) {
    const Grid grid(plane, bounds);
    std::vector<Start> starts;
    for (const double way : {1.0, -1.0}) {
        if (way < 0 && bounds.is_one_way) continue;
        std::vector<Start> row;
        for (int i = 0;; ++i) {
            const double q = bounds.wave_number_least + i * kWaveNumberStep;
            row.push_back(grid.best(way * std::min(q, bounds.wave_number_most)));
            if (q >= bounds.wave_number_most) break;
        }
        for (const Start& start : dips(row)) starts.push_back(start);
    }
    std::stable_sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.cost < b.cost; });
    std::vector<WaveUnknowns> waves;
    for (const Start& start : starts) waves.push_back(start.unknowns);
    return waves;
}

}  // namespace tuftwave
