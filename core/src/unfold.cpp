// Based on: our own. On the inside of a bend whose radius is smaller than the tuft's, neighbouring rings cross and the
// surface turns inside out. Each column of corners is cut back there just so far that it still runs forwards, and the
// cut fades along the column at 45 degrees, which reads as a crease.
#include "unfold.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "bezier.hpp"
#include "corners.hpp"
#include "tuftwave/wide.hpp"

namespace tuftwave {
namespace {

/// Of the centre line's advance from ring to ring, a column keeps at least this share.
constexpr double kLeastAdvance = 0.1;
/// How quickly a cut fades along the centre line: metres of cut per metre of length.
constexpr double kFadeSlope = 1.0;
/// A tuft that leaves the scalp at right angles has fewer; and rings around them, as far as a cut fades.
constexpr std::size_t kUsualFolds = 16, kUsualRings = 24;
/// Rings that a bridge looks ahead at most, which bounds the work.
constexpr std::size_t kBridgedRings = 64;

TUFTWAVE_BODY double widest(const Ring& ring) {
    return ring.half_width < ring.half_thickness ? ring.half_thickness : ring.half_width;
}

/// From one ring to the next.
struct Pair {
    Vec3 forwards;   // unit; the mean tangent, or the straight way where the tangents turn away from it
    double advance;  // of the centre along it, metres; 0 where the rings coincide

    TUFTWAVE_BODY Pair(const Ring& a, const Ring& b) {
        const Vec3 step = b.frame.point - a.frame.point, tangents = a.frame.tangent + b.frame.tangent;
        const Vec3 way = bezier::chosen(dot(step, tangents) > 0, tangents, step);
        const double size = length(way);
        forwards = bezier::chosen(size > 0, way / size, {});
        advance = dot(step, forwards);
    }
};

/// Whether a corner may fall back between two rings; quicker than looking at each. With the angle between the tangents
/// the centre loses at least as much of its advance as the corners lose of theirs.
TUFTWAVE_BODY bool may_fold(const Ring& a, const Ring& b) {
    const Vec3 tangents = a.frame.tangent + b.frame.tangent;
    const double advance = (1 - kLeastAdvance) * dot(b.frame.point - a.frame.point, tangents);
    const double width = widest(a) + widest(b), turn_square = 2 * (1 - dot(a.frame.tangent, b.frame.tangent));
    return !(advance > 0 && width * width * turn_square <= advance * advance);
}

/// Ring `ring` and the one before it.
struct Fold {
    std::size_t ring;
    Pair pair;
};

TUFTWAVE_BODY double distance(const Ring& a, const Ring& b) { return length(b.frame.point - a.frame.point); }

TUFTWAVE_BODY double larger(double a, double b) { return a > b ? a : b; }
TUFTWAVE_BODY double smaller(double a, double b) { return a < b ? a : b; }

/// The rings around all folds, as far as a cut can fade, with a row of corners for each.
/// @tparam kRow  Corners::padded()
template <std::size_t kRow>
class Window {
  public:
    /// @param to  behind the last ring
    Window(const Rings& rings, std::size_t from, std::size_t to, std::span<const Fold> folds, const Corners& corners)
        : rings_(rings),
          first_(from),
          count_(to - from),
          folds_(folds),
          corners_(corners),
          more_(count_ > kUsualRings ? std::make_unique_for_overwrite<Cell[]>(count_) : nullptr),
          cells_(more_ ? more_.get() : usual_.data()) {}

    TUFTWAVE_BODY static void unfold(Window& window, std::vector<float>& shares) {
        window.measure_corners();
        window.cut_folds();
        if (window.has_valley()) window.bridge();
        window.fade();
        window.find_shares(shares);
    }

  private:
    struct alignas(64) Row {
        std::array<double, kRow> corner;

        TUFTWAVE_BODY double& operator[](std::size_t k) { return corner[k]; }
        TUFTWAVE_BODY double operator[](std::size_t k) const { return corner[k]; }
        TUFTWAVE_BODY void fill(double value) {
            for (std::size_t k = 0; k < kRow; ++k) corner[k] = value;
        }
    };
    /// What is known at a ring.
    struct Cell {
        Row sizes, cuts;  // of each corner from the centre; taken off that
        double distance;  // to the next ring's centre, metres
    };
    enum class Towards { kRoot, kTip };

    TUFTWAVE_BODY Ring ring(std::size_t i) const { return rings_[first_ + i]; }

    TUFTWAVE_BODY void measure_corners() {
        for (std::size_t i = 0; i + 1 < count_; ++i) cells_[i].distance = distance(ring(i), ring(i + 1));
        const double *cosines = corners_.cosines(), *sines = corners_.sines();
        for (std::size_t i = 0; i < count_; ++i) {
            const double thickness = ring(i).half_thickness, width = ring(i).half_width;
            Row& sizes = cells_[i].sizes;
            if (thickness == width) {
                sizes.fill(width);
                continue;
            }
            for (std::size_t k = 0; k < kRow; ++k) {
                const double up = thickness * cosines[k], across = width * sines[k];
                sizes[k] = std::sqrt(up * up + across * across);
            }
        }
    }

    /// Cuts every corner back just so far that it runs forwards from ring to ring.
    TUFTWAVE_BODY void cut_folds() {
        const double *cosines = corners_.cosines(), *sines = corners_.sines();
        for (std::size_t i = 0; i < count_; ++i) cells_[i].cuts.fill(0);
        for (const auto& [at, pair] : folds_) {
            const Ring a = ring(at - 1), b = ring(at);
            const double a_up = a.half_thickness * dot(a.frame.normal, pair.forwards);
            const double a_across = a.half_width * dot(a.frame.binormal(), pair.forwards);
            const double b_up = b.half_thickness * dot(b.frame.normal, pair.forwards);
            const double b_across = b.half_width * dot(b.frame.binormal(), pair.forwards);
            const double allowed = pair.advance > 0 ? (1 - kLeastAdvance) * pair.advance : 0;
            const double whole = pair.advance > 0 ? 0 : 1;  // where the centre stays, no corner may stand off
            const Row &a_sizes = cells_[at - 1].sizes, &b_sizes = cells_[at].sizes;
            Row &a_cuts = cells_[at - 1].cuts, &b_cuts = cells_[at].cuts;
            for (std::size_t k = 0; k < kRow; ++k) {
                const double ahead = a_up * cosines[k] + a_across * sines[k],
                             back = b_up * cosines[k] + b_across * sines[k];
                const double lost = larger(ahead, 0) + larger(-back, 0);
                const double part = lost > allowed ? 1 - allowed / lost : 0;
                a_cuts[k] = larger(a_cuts[k], larger(part, whole) * a_sizes[k]);
                b_cuts[k] = larger(b_cuts[k], larger(part, whole) * b_sizes[k]);
            }
        }
    }

    /// Whether a corner is cut less than both before and after it.
    TUFTWAVE_BODY bool has_valley() const {
        const std::size_t from = folds_.front().ring - 1, to = folds_.back().ring;
        Row deepest = cells_[from].cuts, falls, valleys;  // so far; 1 where it has been less since; and rose again
        falls.fill(0);
        valleys.fill(0);
        for (std::size_t i = from + 1; i <= to; ++i) {
            const Row &cuts = cells_[i].cuts, &last = cells_[i - 1].cuts;
            for (std::size_t k = 0; k < kRow; ++k) {
                valleys[k] = cuts[k] > last[k] ? larger(valleys[k], falls[k]) : valleys[k];
                falls[k] = cuts[k] < deepest[k] ? 1 : falls[k];
                deepest[k] = larger(deepest[k], cuts[k]);
            }
        }
        return std::any_of(valleys.corner.begin(), valleys.corner.end(), [](double valley) { return valley > 0; });
    }

    /// Between two bends that are nearer than the tuft is thick, the column would recover and stand in the fold as a
    /// fin: it stays cut as far as the lesser of the deepest cuts before and after.
    TUFTWAVE_BODY void bridge() {
        const std::size_t from = folds_.front().ring - 1, to = folds_.back().ring;
        std::vector<Row> bridged;
        bridged.reserve(to + 1 - from);
        for (std::size_t i = from; i <= to; ++i) {
            const Row before = deepest(i, Towards::kRoot), after = deepest(i, Towards::kTip);
            Row& cuts = bridged.emplace_back(cells_[i].cuts);
            for (std::size_t k = 0; k < kRow; ++k) cuts[k] = larger(cuts[k], smaller(before[k], after[k]));
        }
        for (std::size_t i = from; i <= to; ++i) cells_[i].cuts = bridged[i - from];
    }

    /// The deepest cut of each corner from ring `i` on, as far as the corner stands from the centre.
    TUFTWAVE_BODY Row deepest(std::size_t i, Towards side) const {
        const std::size_t there = side == Towards::kTip ? count_ - 1 - i : i;
        const Row& spans = cells_[i].sizes;
        const double furthest = widest(ring(i));
        Row deepest = cells_[i].cuts;
        double walked = 0;
        for (std::size_t step = 1; step <= std::min(there, kBridgedRings); ++step) {
            walked += cells_[side == Towards::kTip ? i + step - 1 : i - step].distance;
            if (walked > furthest) break;
            const Row& cuts = cells_[side == Towards::kTip ? i + step : i - step].cuts;
            for (std::size_t k = 0; k < kRow; ++k) deepest[k] = larger(deepest[k], walked > spans[k] ? 0 : cuts[k]);
        }
        return deepest;
    }

    TUFTWAVE_BODY void fade() {
        for (std::size_t i = 1; i < count_; ++i) fade(cells_[i - 1].cuts, cells_[i - 1].distance, cells_[i].cuts);
        for (std::size_t i = count_ - 1; i > 0; --i) fade(cells_[i].cuts, cells_[i - 1].distance, cells_[i - 1].cuts);
    }

    TUFTWAVE_BODY static void fade(const Row& from, double distance, Row& to) {
        const double lost = kFadeSlope * distance;
        for (std::size_t k = 0; k < kRow; ++k) to[k] = larger(to[k], from[k] - lost);
    }

    TUFTWAVE_BODY void find_shares(std::vector<float>& shares) const {
        for (std::size_t i = 0; i < count_; ++i) {
            const Row &cuts = cells_[i].cuts, &sizes = cells_[i].sizes;
            for (std::size_t k = 0; k < kRow; ++k) {
                const double left = 1 - cuts[k] / sizes[k];
                shares[i * kRow + k] = static_cast<float>(cuts[k] > 0 ? larger(left, 0) : 1);
            }
        }
    }

    const Rings& rings_;
    const std::size_t first_, count_;
    const std::span<const Fold> folds_;  // counted from the first ring
    const Corners& corners_;
    std::array<Cell, kUsualRings> usual_;
    const std::unique_ptr<Cell[]> more_;
    Cell* const cells_;
};

/// 1 for each ring that may fold with the next, 0 for the others.
using Marks = std::array<float, 64>;

TUFTWAVE_BODY void mark_folds(const Rings& rings, std::size_t from, std::size_t count, Marks& marks) {
    for (std::size_t k = 0; k < count; ++k) marks[k] = may_fold(rings[from + k], rings[from + k + 1]) ? 1 : 0;
}

std::vector<Fold> folds_of(const Rings& rings, Vectors vectors) {
    std::vector<Fold> folds;
    folds.reserve(kUsualFolds);
    Marks marks;
    for (std::size_t from = 0; from + 1 < rings.size(); from += marks.size()) {
        const std::size_t count = std::min(marks.size(), rings.size() - 1 - from);
        run_with<mark_folds>(vectors, rings, from, count, marks);
        for (std::size_t i = from + 1; i <= from + count; ++i) {
            if (marks[i - 1 - from] > 0) folds.push_back({i, Pair(rings[i - 1], rings[i])});
        }
    }
    return folds;
}

}  // namespace

Reach unfolding_reach(const Rings& rings, int sides, Vectors vectors) {
    std::vector<Fold> folds = folds_of(rings, vectors);
    if (folds.empty()) return {};
    double deepest = 0;  // no cut is deeper, and none fades further
    for (const Fold& fold : folds)
        deepest = std::max({deepest, widest(rings[fold.ring - 1]), widest(rings[fold.ring])});
    std::size_t first = folds.front().ring - 1, last = folds.back().ring;
    for (double walked = 0; first > 0 && walked <= deepest / kFadeSlope; --first)
        walked += distance(rings[first - 1], rings[first]);
    for (double walked = 0; last + 1 < rings.size() && walked <= deepest / kFadeSlope; ++last)
        walked += distance(rings[last], rings[last + 1]);
    for (Fold& fold : folds) fold.ring -= first;

    const Corners& corners = corners_of(sides);
    Reach reach{first, corners.padded(), std::vector<float>((last + 1 - first) * corners.padded())};
    with_row_of(corners, [&]<std::size_t kRow>() {
        Window<kRow> window(rings, first, last + 1, folds, corners);
        run_with<Window<kRow>::unfold>(vectors, window, reach.shares);
    });
    return reach;
}

}  // namespace tuftwave
