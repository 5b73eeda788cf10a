// Based on: our own. On the inside of a bend whose radius is smaller than the tuft's, neighbouring rings cross and the
// surface turns inside out. Each column of corners is cut back there just so far that it still runs forwards, and the
// cut fades along the column at 45 degrees, which reads as a crease.
#include "unfold.hpp"

#include <algorithm>

#include "bezier.hpp"
#include "corners.hpp"
#include "tuftwave/wide.hpp"

namespace tuftwave {
namespace {

/// Of the centre line's advance from ring to ring, a column keeps at least this share.
constexpr double kLeastAdvance = 0.1;
/// How quickly a cut fades along the centre line: metres of cut per metre of length.
constexpr double kFadeSlope = 1.0;
/// Rings that a bridge looks ahead at most, which bounds the work.
constexpr std::size_t kBridgedRings = 64;

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

/// A ring, and what lies between it and the one before.
struct Fold {
    std::size_t ring;
    Pair pair;
};

/// What is known of all pairs of neighbouring rings before any corner is looked at.
struct Spacing {
    std::vector<double> distances;  // of the centres, metres
    std::vector<Fold> folds;        // where a corner may fall back; quicker than looking at each
};

TUFTWAVE_BODY double most_lost(const Ring& ring, const Vec3& forwards) {
    const double widest = ring.half_width < ring.half_thickness ? ring.half_thickness : ring.half_width;
    return widest * length(rejected(forwards, ring.frame.tangent));
}

TUFTWAVE_BODY void look_at_pairs(std::span<const Ring> rings, std::span<double> distances, std::span<double> folds) {
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const Pair pair(rings[i], rings[i + 1]);
        distances[i] = length(rings[i + 1].frame.point - rings[i].frame.point);
        const double lost = most_lost(rings[i], pair.forwards) + most_lost(rings[i + 1], pair.forwards);
        folds[i] = lost <= (1 - kLeastAdvance) * pair.advance ? 0.0 : 1.0;
    }
}

Spacing spacing_of(std::span<const Ring> rings, Vectors vectors) {
    Spacing spacing{std::vector<double>(rings.size() - 1), {}};
    std::vector<double> folds(spacing.distances.size());
    run_with<look_at_pairs>(vectors, rings, spacing.distances, folds);
    for (std::size_t i = 0; i < folds.size(); ++i) {
        if (folds[i] != 0) spacing.folds.push_back({i + 1, Pair(rings[i], rings[i + 1])});
    }
    return spacing;
}

/// One corner of every ring, root to tip.
class Column {
  public:
    Column(std::span<const Ring> rings, const Spacing& spacing, const Corners& corners)
        : rings_(rings), spacing_(spacing), corners_(corners), cut_(rings.size(), 0.0), bridged_(rings.size(), 0.0) {}

    /// Decides how many metres are taken off the corner's distance from the centre line: from `first` to `end`.
    void cut(std::size_t corner) {
        corner_ = corner;
        std::fill(cut_.begin() + at(first), cut_.begin() + at(end), 0.0);
        first = end = 0;
        for (const auto& [ring, pair] : spacing_.folds) cut_pair(ring, pair);
        if (end == 0) return;
        bridge();
        for (std::size_t i = first + 1; i < rings_.size() && (i < end || cut_[i - 1] > 0); ++i) fade(i - 1, i);
        for (std::size_t i = end - 1; i > 0 && (i > first || cut_[i] > 0); --i) fade(i, i - 1);
    }

    std::size_t first = 0, end = 0;  ///< the rings where the corner is cut

    double share_left(std::size_t ring) const {
        if (!(cut_[ring] > 0)) return 1;
        const double size = reach(ring);
        return size > 0 ? std::max(0.0, 1 - cut_[ring] / size) : 1;
    }

  private:
    Vec3 offset(std::size_t ring) const { return corners_.offset(rings_[ring], corner_); }
    double reach(std::size_t ring) const { return length(offset(ring)); }

    void cut_pair(std::size_t i, const Pair& pair) {
        if (!(pair.advance > 0)) return cut_whole(i);
        const Vec3 before = offset(i - 1), here = offset(i);
        const double lost = std::max(0.0, dot(before, pair.forwards)) + std::max(0.0, -dot(here, pair.forwards));
        const double allowed = (1 - kLeastAdvance) * pair.advance;
        if (lost <= allowed) return;
        cut_[i - 1] = std::max(cut_[i - 1], (1 - allowed / lost) * length(before));
        cut_[i] = std::max(cut_[i], (1 - allowed / lost) * length(here));
        include(i - 1, i + 1);
    }

    void cut_whole(std::size_t i) {
        for (const std::size_t ring : {i - 1, i}) cut_[ring] = reach(ring);
        include(i - 1, i + 1);
    }

    void include(std::size_t from, std::size_t to) {
        first = end == 0 ? from : std::min(first, from);
        end = std::max(end, to);
    }

    /// Between two bends that are nearer than the tuft is thick, the column would recover and stand in the fold as a
    /// fin: it stays cut as far as the lesser of the deepest cuts before and after.
    void bridge() {
        std::copy(cut_.begin() + at(first), cut_.begin() + at(end), bridged_.begin() + at(first));
        for (std::size_t i = first; i < end; ++i) {
            const double span = reach(i);
            const double before = deepest_cut(i, span, Towards::kRoot), after = deepest_cut(i, span, Towards::kTip);
            bridged_[i] = std::max(cut_[i], std::min(before, after));
        }
        std::copy(bridged_.begin() + at(first), bridged_.begin() + at(end), cut_.begin() + at(first));
    }

    enum class Towards { kRoot, kTip };

    /// The deepest cut from ring `i` on. @param span  how far is looked, metres: as the corner there is from the middle
    double deepest_cut(std::size_t i, double span, Towards side) const {
        const std::size_t rings_there = side == Towards::kTip ? cut_.size() - 1 - i : i;
        double deepest = cut_[i], walked = 0;
        std::size_t at = i;
        for (std::size_t k = 0; k < std::min(rings_there, kBridgedRings); ++k) {
            const std::size_t next = side == Towards::kTip ? at + 1 : at - 1;
            walked += spacing_.distances[std::min(at, next)];
            if (walked > span) break;
            deepest = std::max(deepest, cut_[next]);
            at = next;
        }
        return deepest;
    }

    void fade(std::size_t from, std::size_t to) {
        const double faded = cut_[from] - kFadeSlope * spacing_.distances[std::min(from, to)];
        if (!(faded > cut_[to])) return;
        cut_[to] = faded;
        include(to, to + 1);
    }

    static std::ptrdiff_t at(std::size_t ring) { return static_cast<std::ptrdiff_t>(ring); }

    std::span<const Ring> rings_;
    const Spacing& spacing_;
    const Corners& corners_;
    std::size_t corner_ = 0;
    std::vector<double> cut_, bridged_;
};

}  // namespace

std::vector<float> unfolding_reach(std::span<const Ring> rings, int sides, Vectors vectors) {
    const Spacing spacing = spacing_of(rings, vectors);
    if (spacing.folds.empty()) return {};
    const Corners& corners = corners_of(sides);
    std::vector<float> reach(rings.size() * corners.count(), 1.0F);
    Column column(rings, spacing, corners);
    for (std::size_t j = 0; j < corners.count(); ++j) {
        column.cut(j);
        for (std::size_t i = column.first; i < column.end; ++i)
            reach[i * corners.count() + j] = static_cast<float>(column.share_left(i));
    }
    return reach;
}

}  // namespace tuftwave
