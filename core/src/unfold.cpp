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
/// A tuft that leaves the scalp at right angles has fewer.
constexpr std::size_t kUsualFolds = 16;
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

/// The rings around all folds, as far as a cut can fade, with a row of corners for each.
struct Window {
    const Rings& rings;
    std::size_t first, count;     // of the rings
    std::span<const Fold> folds;  // counted from the first ring
    const Corners& corners;
    std::span<double> distances;    // to the next ring's centre, metres
    std::span<double> sizes, cuts;  // of each corner from the centre; taken off that

    Window(const Rings& all, std::size_t from, std::size_t to, std::span<const Fold> their_folds, int sides)
        : rings(all),
          first(from),
          count(to - from),
          folds(their_folds),
          corners(corners_of(sides)),
          rows_(std::make_unique_for_overwrite<double[]>(count * (2 * row() + 1))) {
        sizes = {rows_.get(), count * row()};
        cuts = {sizes.data() + sizes.size(), sizes.size()};
        distances = {cuts.data() + cuts.size(), count};
    }

    std::size_t row() const { return corners.padded(); }
    TUFTWAVE_BODY Ring ring(std::size_t i) const { return rings[first + i]; }

  private:
    std::unique_ptr<double[]> rows_;
};

TUFTWAVE_BODY double larger(double a, double b) { return a > b ? a : b; }
TUFTWAVE_BODY double smaller(double a, double b) { return a < b ? a : b; }

TUFTWAVE_BODY void measure_distances(Window& window) {
    for (std::size_t i = 0; i + 1 < window.count; ++i)
        window.distances[i] = distance(window.ring(i), window.ring(i + 1));
}

TUFTWAVE_BODY void measure_corners(Window& window) {
    const double *cosines = window.corners.cosines(), *sines = window.corners.sines();
    for (std::size_t i = 0; i < window.count; ++i) {
        const double thickness = window.ring(i).half_thickness, width = window.ring(i).half_width;
        double* const sizes = &window.sizes[i * window.row()];
        if (thickness == width) {
            std::fill_n(sizes, window.row(), width);
            continue;
        }
        for (std::size_t k = 0; k < window.row(); ++k) {
            const double up = thickness * cosines[k], across = width * sines[k];
            sizes[k] = std::sqrt(up * up + across * across);
        }
    }
}

/// Cuts every corner back just so far that it runs forwards from ring to ring.
TUFTWAVE_BODY void cut_folds(Window& window) {
    const double *cosines = window.corners.cosines(), *sines = window.corners.sines();
    std::ranges::fill(window.cuts, 0.0);
    for (const auto& [ring, pair] : window.folds) {
        const Ring a = window.ring(ring - 1), b = window.ring(ring);
        const double a_up = a.half_thickness * dot(a.frame.normal, pair.forwards);
        const double a_across = a.half_width * dot(a.frame.binormal(), pair.forwards);
        const double b_up = b.half_thickness * dot(b.frame.normal, pair.forwards);
        const double b_across = b.half_width * dot(b.frame.binormal(), pair.forwards);
        const double allowed = pair.advance > 0 ? (1 - kLeastAdvance) * pair.advance : 0;
        const double whole = pair.advance > 0 ? 0 : 1;  // where the centre does not advance, no corner may stand off
        const double *a_sizes = &window.sizes[(ring - 1) * window.row()], *b_sizes = a_sizes + window.row();
        double *a_cuts = &window.cuts[(ring - 1) * window.row()], *b_cuts = a_cuts + window.row();
        for (std::size_t k = 0; k < window.row(); ++k) {
            const double ahead = a_up * cosines[k] + a_across * sines[k],
                         back = b_up * cosines[k] + b_across * sines[k];
            const double lost = larger(ahead, 0) + larger(-back, 0);
            const double part = lost > allowed ? 1 - allowed / lost : 0;
            a_cuts[k] = larger(a_cuts[k], larger(part, whole) * a_sizes[k]);
            b_cuts[k] = larger(b_cuts[k], larger(part, whole) * b_sizes[k]);
        }
    }
}

enum class Towards { kRoot, kTip };

/// Raises `deepest` to the deepest cut of each corner from ring `i` on, as far as the corner stands from the centre.
TUFTWAVE_BODY void find_deepest(const Window& window, std::size_t i, Towards side, double* deepest) {
    const std::size_t there = side == Towards::kTip ? window.count - 1 - i : i, row = window.row();
    const double *cuts = &window.cuts[i * row], *spans = &window.sizes[i * row];
    const double furthest = widest(window.ring(i));
    for (std::size_t k = 0; k < row; ++k) deepest[k] = cuts[k];
    double walked = 0;
    for (std::size_t step = 0; step < std::min(there, kBridgedRings); ++step) {
        walked += window.distances[side == Towards::kTip ? i + step : i - step - 1];
        if (walked > furthest) break;
        cuts = side == Towards::kTip ? cuts + row : cuts - row;
        for (std::size_t k = 0; k < row; ++k) deepest[k] = larger(deepest[k], walked > spans[k] ? 0 : cuts[k]);
    }
}

/// Whether a corner is cut less than both before and after it.
TUFTWAVE_BODY bool has_valley(const Window& window) {
    const std::size_t row = window.row(), from = window.folds.front().ring - 1, to = window.folds.back().ring;
    std::array<double, Corners::kMost> deepest, falls,
        valleys;  // so far; 1 where it has been less since; and rose again
    for (std::size_t k = 0; k < row; ++k) deepest[k] = falls[k] = valleys[k] = 0;
    for (std::size_t i = from; i <= to; ++i) {
        const double *cuts = &window.cuts[i * row], *last = i > from ? cuts - row : cuts;
        for (std::size_t k = 0; k < row; ++k) {
            valleys[k] = cuts[k] > last[k] ? larger(valleys[k], falls[k]) : valleys[k];
            falls[k] = cuts[k] < deepest[k] ? 1 : falls[k];
            deepest[k] = larger(deepest[k], cuts[k]);
        }
    }
    return std::any_of(valleys.begin(), valleys.begin() + static_cast<std::ptrdiff_t>(row),
                       [](double valley) { return valley > 0; });
}

/// Between two bends that are nearer than the tuft is thick, the column would recover and stand in the fold as a fin:
/// it stays cut as far as the lesser of the deepest cuts before and after.
TUFTWAVE_BODY void bridge(Window& window) {
    const std::size_t from = window.folds.front().ring - 1, to = window.folds.back().ring;
    std::array<double, Corners::kMost> before, after;
    std::vector<double> cuts(window.cuts.begin(), window.cuts.end());
    for (std::size_t i = from; i <= to; ++i) {
        find_deepest(window, i, Towards::kRoot, before.data());
        find_deepest(window, i, Towards::kTip, after.data());
        double* const bridged = &cuts[i * window.row()];
        for (std::size_t k = 0; k < window.row(); ++k) bridged[k] = larger(bridged[k], smaller(before[k], after[k]));
    }
    std::copy(cuts.begin(), cuts.end(), window.cuts.begin());
}

TUFTWAVE_BODY void fade(Window& window) {
    const std::size_t row = window.row();
    const auto carry = [&](std::size_t from, std::size_t to) {
        const double lost = kFadeSlope * window.distances[std::min(from, to)];
        const double* const cuts = &window.cuts[from * row];
        double* const faded = &window.cuts[to * row];
        for (std::size_t k = 0; k < row; ++k) faded[k] = larger(faded[k], cuts[k] - lost);
    };
    for (std::size_t i = 1; i < window.count; ++i) carry(i - 1, i);
    for (std::size_t i = window.count - 1; i > 0; --i) carry(i, i - 1);
}

TUFTWAVE_BODY void find_shares(const Window& window, std::vector<float>& shares) {
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double left = 1 - window.cuts[i] / window.sizes[i];
        shares[i] = static_cast<float>(window.cuts[i] > 0 ? larger(left, 0) : 1);
    }
}

TUFTWAVE_BODY void unfold(Window& window, std::vector<float>& shares) {
    measure_distances(window);
    measure_corners(window);
    cut_folds(window);
    if (has_valley(window)) bridge(window);
    fade(window);
    find_shares(window, shares);
}

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

    Window window(rings, first, last + 1, folds, sides);
    Reach reach{first, window.row(), std::vector<float>(window.cuts.size())};
    run_with<unfold>(vectors, window, reach.shares);
    return reach;
}

}  // namespace tuftwave
