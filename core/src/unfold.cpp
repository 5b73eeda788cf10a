// Based on: our own. On the inside of a bend whose radius is smaller than the tuft's, neighbouring rings cross and the
// surface turns inside out. Each column of corners is cut back there just so far that it still runs forwards, and the
// cut fades along the column at 45 degrees, which reads as a crease.
#include "unfold.hpp"

#include <algorithm>

#include "corners.hpp"

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

    Pair(const Ring& a, const Ring& b) {
        const Vec3 step = b.frame.point - a.frame.point, tangents = a.frame.tangent + b.frame.tangent;
        const Vec3 way = dot(step, tangents) > 0 ? tangents : step;
        const double size = length(way);
        if (size > 0) forwards = way / size;
        advance = dot(step, forwards);
    }
};

/// False when no corner can fall back; quicker than looking at each.
bool may_fold(std::span<const Ring> rings) {
    for (std::size_t i = 1; i < rings.size(); ++i) {
        const Pair pair(rings[i - 1], rings[i]);
        double lost = 0;
        for (const Ring* ring : {&rings[i - 1], &rings[i]}) {
            lost +=
                std::max(ring->half_width, ring->half_thickness) * length(rejected(pair.forwards, ring->frame.tangent));
        }
        if (!(lost <= (1 - kLeastAdvance) * pair.advance)) return true;
    }
    return false;
}

/// One corner of every ring, root to tip.
class Column {
  public:
    Column(std::span<const Ring> rings, const Corners& corners, std::size_t corner)
        : rings_(rings), cut_(rings.size(), 0.0) {
        for (const Ring& ring : rings) offsets_.push_back(corners.offset(ring, corner));
    }

    /// Decides how many metres are taken off each corner's distance.
    void cut() {
        for (std::size_t i = 1; i < rings_.size(); ++i) cut_pair(i);
        bridge();
        for (std::size_t i = 1; i < rings_.size(); ++i) fade(i - 1, i);
        for (std::size_t i = rings_.size() - 1; i > 0; --i) fade(i, i - 1);
    }

    double share_left(std::size_t ring) const {
        const double size = length(offsets_[ring]);
        return size > 0 ? std::max(0.0, 1 - cut_[ring] / size) : 1;
    }

  private:
    double step_length(std::size_t a, std::size_t b) const {
        return length(rings_[b].frame.point - rings_[a].frame.point);
    }

    void cut_pair(std::size_t i) {
        const Pair pair(rings_[i - 1], rings_[i]);
        if (!(pair.advance > 0)) return cut_whole(i);
        const double lost =
            std::max(0.0, dot(offsets_[i - 1], pair.forwards)) + std::max(0.0, -dot(offsets_[i], pair.forwards));
        const double allowed = (1 - kLeastAdvance) * pair.advance;
        if (lost <= allowed) return;
        for (const std::size_t ring : {i - 1, i}) {
            cut_[ring] = std::max(cut_[ring], (1 - allowed / lost) * length(offsets_[ring]));
        }
    }

    void cut_whole(std::size_t i) {
        for (const std::size_t ring : {i - 1, i}) cut_[ring] = length(offsets_[ring]);
    }

    /// Between two bends that are nearer than the tuft is thick, the column would recover and stand in the fold as a
    /// fin: it stays cut as far as the lesser of the deepest cuts before and after.
    void bridge() {
        std::vector<double> bridged = cut_;
        for (std::size_t i = 0; i < cut_.size(); ++i) {
            bridged[i] = std::max(cut_[i], std::min(deepest_cut(i, Towards::kRoot), deepest_cut(i, Towards::kTip)));
        }
        cut_ = std::move(bridged);
    }

    enum class Towards { kRoot, kTip };

    /// The deepest cut from ring `i` on, as far as the corner there is from the centre line.
    double deepest_cut(std::size_t i, Towards end) const {
        const double span = length(offsets_[i]);
        const std::size_t rings_there = end == Towards::kTip ? cut_.size() - 1 - i : i;
        double deepest = cut_[i], walked = 0;
        std::size_t at = i;
        for (std::size_t k = 0; k < std::min(rings_there, kBridgedRings); ++k) {
            const std::size_t next = end == Towards::kTip ? at + 1 : at - 1;
            walked += step_length(at, next);
            if (walked > span) break;
            deepest = std::max(deepest, cut_[next]);
            at = next;
        }
        return deepest;
    }

    void fade(std::size_t from, std::size_t to) {
        cut_[to] = std::max(cut_[to], cut_[from] - kFadeSlope * step_length(from, to));
    }

    std::span<const Ring> rings_;
    std::vector<Vec3> offsets_;
    std::vector<double> cut_;
};

}  // namespace

std::vector<float> unfolding_reach(std::span<const Ring> rings, int sides) {
    if (!may_fold(rings)) return {};
    const Corners corners(sides);
    std::vector<float> reach(rings.size() * corners.count(), 1.0F);
    for (std::size_t j = 0; j < corners.count(); ++j) {
        Column column(rings, corners, j);
        column.cut();
        for (std::size_t i = 0; i < rings.size(); ++i)
            reach[i * corners.count() + j] = static_cast<float>(column.share_left(i));
    }
    return reach;
}

}  // namespace tuftwave
