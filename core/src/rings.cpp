// Based on: our own choice; the paper does not say how a tuft is meshed.
#include "rings.hpp"

#include <algorithm>

#include "tuftwave/elementary.hpp"

namespace tuftwave {
namespace {

/// A ring and the next are never turned further apart than this, radians (about 34 degrees), so that shading stays
/// smooth.
constexpr double kLargestTurn = 0.6;
/// Rings are at most a bone's length over this apart, so that a bent bone bends the mesh.
constexpr int kRingsPerBone = 2;
/// 2^-20 of a tuft is a quarter of a micrometre on a hair of 25 cm; only the blunt ends of the round taper come near
/// it.
constexpr int kDeepestHalving = 20;
/// Between three places that are looked at, a cubic's error is at most 8 percent larger than at them.
constexpr double kLookedAt = 0.92;
/// Where a ring count is given: the share of the arc length that a turn by one radian counts for.
constexpr double kTurnWorth = 0.08;

class RingChooser {
  public:
    RingChooser(const Curve& curve, const Tuft& tuft, double diameter, const MeshDetail& detail)
        : curve_(curve), tuft_(tuft), half_diameter_(diameter / 2), detail_(detail) {}

    /// False when there would be more than `most` rings.
    bool by_tolerance(std::size_t most) {
        most_ = most;
        const Ring first = ring_at(0);
        const double widest = tuft_.widest_at / 100;
        if (widest >= 1) return halve(first, ring_at(1), 0) && keep(ring_at(1));
        const Ring middle = ring_at(widest);
        return halve(first, middle, 0) && keep(middle) && halve(middle, ring_at(1), 0);
    }

    void by_count(int count) {
        const bool flat_tip = tuft_.widest_at >= 100;
        const double whole = curve_.arc_length();
        for (int i = 1; i <= count; ++i) {
            const double part = static_cast<double>(i) / (flat_tip ? count : count + 1);
            rings_.push_back(ring_at(curve_.along_at(part, kTurnWorth * whole) / whole));
        }
    }

    std::vector<Ring> take() { return std::move(rings_); }

  private:
    Ring ring_at(double along) const {
        Ring ring{curve_.at(along * curve_.arc_length()), along, 0, 0};
        const double width = half_diameter_ * profile_width(tuft_.taper, along, tuft_.widest_at / 100);
        ring.half_width = width;
        ring.half_thickness = tuft_.section == Section::kEllipse ? width * (1 - tuft_.flatness) : width;
        const auto turn = elementary::sincos((tuft_.roll_deg + tuft_.twist_deg * along) * kRadiansPerDegree);
        ring.frame.normal = turn.cos * ring.frame.normal + turn.sin * ring.frame.binormal();
        return ring;
    }

    /// Keeps the rings strictly between `a` and `b`.
    bool halve(const Ring& a, const Ring& b, int halvings) {
        const Ring middle = ring_at((a.along + b.along) / 2);
        if (halvings >= kDeepestHalving || is_fine(a, middle, b)) return true;
        return halve(a, middle, halvings + 1) && keep(middle) && halve(middle, b, halvings + 1);
    }

    bool keep(const Ring& ring) {
        rings_.push_back(ring);
        return rings_.size() <= most_;
    }

    /// Whether the straight piece from `a` to `b` is as good as the curve between them.
    bool is_fine(const Ring& a, const Ring& middle, const Ring& b) const {
        const double step = b.along - a.along;
        if (step * kRingsPerBone * tuft_.joints > 1) return false;
        const double turn =
            curve_.turning_until(b.along * curve_.arc_length()) - curve_.turning_until(a.along * curve_.arc_length());
        const double twist = std::abs(tuft_.twist_deg) * kRadiansPerDegree * step;
        if (turn > kLargestTurn || twist > kLargestTurn) return false;
        const double widest = std::max({a.half_width, middle.half_width, b.half_width});
        const double side_error = widest * (turn * turn + twist * twist) / 8;  // sagitta of an arc
        const double allowed = kLookedAt * detail_.tolerance - side_error;
        // An S crosses its chord in the middle, so the quarters are looked at too.
        return error_at(a, middle, b, 0.5) <= allowed && error_at(a, ring_at(a.along + step / 4), b, 0.25) <= allowed &&
               error_at(a, ring_at(b.along - step / 4), b, 0.75) <= allowed;
    }

    /// How far `ring` lies from the straight piece, `part` of the way from `a` to `b`, and how much it differs in
    /// width.
    static double error_at(const Ring& a, const Ring& ring, const Ring& b, double part) {
        const Vec3 centre = (1 - part) * a.frame.point + part * b.frame.point;
        const double width = (1 - part) * a.half_width + part * b.half_width;
        return length(ring.frame.point - centre) + std::abs(ring.half_width - width);
    }

    const Curve& curve_;
    const Tuft& tuft_;
    const double half_diameter_;
    const MeshDetail& detail_;
    std::size_t most_ = 0;
    std::vector<Ring> rings_;
};

}  // namespace

Result<std::vector<Ring>> choose_rings(const Curve& curve, const Tuft& tuft, double diameter, const MeshDetail& detail,
                                       const Limits& limits) {
    RingChooser chooser(curve, tuft, diameter, detail);
    if (detail.rings) {
        chooser.by_count(*detail.rings);
        return chooser.take();
    }
    if (!chooser.by_tolerance(limits.rings_per_tuft)) {
        return Error{ErrorCode::kTooMany,
                     "",
                     detail.tolerance,
                     "a tuft of at most " + std::to_string(limits.rings_per_tuft) +
                         " rings; use a larger mesh.tolerance or set mesh.rings",
                     {},
                     {}};
    }
    return chooser.take();
}

}  // namespace tuftwave
