// Based on: our own choice; the paper does not say how a tuft is meshed.
#include "rings.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "elementary_bodies.hpp"
#include "tuftwave/wide.hpp"

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

/// Parts of equal size. @param count  of those up to 1
TUFTWAVE_BODY void divide_evenly(std::span<double> parts, double count) {
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = static_cast<double>(i + 1) / count;
}

TUFTWAVE_BODY void divide(std::span<double> numbers, double by) {
    for (double& number : numbers) number /= by;
}

/// @param widths  as shares of the tuft's; becomes metres
TUFTWAVE_BODY void scale_widths(std::span<double> widths, double half_diameter, double thickness,
                                std::span<double> thicknesses) {
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const double width = half_diameter * widths[i];
        widths[i] = width;
        thicknesses[i] = width * thickness;
    }
}

/// Turns normals about their tangents, as the tuft rolls and twists.
TUFTWAVE_BODY void turn(Rings& rings, const Tuft& tuft) {
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const Ring ring = rings[i];
        const auto turn = elementary::bodies::sincos((tuft.roll_deg + tuft.twist_deg * ring.along) * kRadiansPerDegree);
        rings.frames().set_normal(i, turn.cos * ring.frame.normal + turn.sin * ring.frame.binormal());
    }
}

/// A piece of the tuft that may be halved, as rings: its ends and its middle.
struct Piece {
    Ring from, middle, to;
};

class RingChooser {
  public:
    RingChooser(const Curve& curve, const Tuft& tuft, double diameter, const MeshDetail& detail, Vectors vectors)
        : curve_(curve), tuft_(tuft), half_diameter_(diameter / 2), detail_(detail), vectors_(vectors) {}

    /// Halves pieces until all are fine; all that are equally long at once, since many places are found more quickly
    /// than one. Nothing when there would be more than `most` rings.
    std::optional<Rings> by_tolerance(std::size_t most) const {
        std::vector<Ring> kept;
        std::vector<Piece> pieces = first_pieces(kept), halves;
        for (int halvings = 0; halvings < kDeepestHalving && !pieces.empty(); ++halvings) {
            const Rings quarters = quarters_of(pieces);
            halves.clear();
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                const auto& [from, middle, to] = pieces[i];
                const Ring first = quarters[2 * i], last = quarters[2 * i + 1];
                if (is_fine(pieces[i], first, last)) continue;
                kept.push_back(middle);
                halves.push_back({from, first, middle});
                halves.push_back({middle, last, to});
            }
            if (kept.size() > most) return {};
            std::swap(pieces, halves);
        }
        std::ranges::sort(kept, {}, &Ring::along);
        Rings rings(kept.size());
        for (std::size_t i = 0; i < kept.size(); ++i) rings.set(i, kept[i]);
        return rings;
    }

    Rings by_count(int count) const {
        const bool flat_tip = tuft_.widest_at >= 100;
        const double whole = curve_.arc_length();
        Rings rings(static_cast<std::size_t>(count));
        const std::span<double> along = rings.along();
        run_with<divide_evenly>(vectors_, along, flat_tip ? count : count + 1);
        curve_.at_parts(along, kTurnWorth * whole, along, rings.frames());
        run_with<divide>(vectors_, along, whole);
        shape(rings);
        return rings;
    }

  private:
    Rings rings_at(std::span<const double> along) const {
        std::vector<double> places(along.begin(), along.end());
        for (double& place : places) place *= curve_.arc_length();
        std::vector<CurveFrame> frames(along.size());
        curve_.at(places, frames);
        Rings rings(along.size());
        std::ranges::copy(along, rings.along().begin());
        for (std::size_t i = 0; i < frames.size(); ++i) rings.frames().set(i, frames[i]);
        shape(rings);
        return rings;
    }

    /// Makes rings of frames along the tuft.
    void shape(Rings& rings) const {
        const std::span<double> widths = rings.half_widths(), thicknesses = rings.half_thicknesses();
        profile_widths(tuft_.taper, rings.along(), tuft_.widest_at / 100, widths, vectors_);
        const double thickness = tuft_.section == Section::kEllipse ? 1 - tuft_.flatness : 1;
        run_with<scale_widths>(vectors_, widths, half_diameter_, thickness, thicknesses);
        if (tuft_.roll_deg != 0 || tuft_.twist_deg != 0) run_with<turn>(vectors_, rings, tuft_);
    }

    /// From the root to the widest place, and on to the tip. @param kept  gets the ring where they meet
    std::vector<Piece> first_pieces(std::vector<Ring>& kept) const {
        const double widest = tuft_.widest_at / 100;
        if (widest >= 1) {
            const Rings rings = rings_at(std::array{0.0, 0.5, 1.0});
            kept.push_back(rings[2]);
            return {{rings[0], rings[1], rings[2]}};
        }
        const Rings rings = rings_at(std::array{0.0, widest / 2, widest, (widest + 1) / 2, 1.0});
        kept.push_back(rings[2]);
        return {{rings[0], rings[1], rings[2]}, {rings[2], rings[3], rings[4]}};
    }

    /// The rings a quarter and three quarters of the way along each piece.
    Rings quarters_of(const std::vector<Piece>& pieces) const {
        std::vector<double> along;
        along.reserve(2 * pieces.size());
        for (const Piece& piece : pieces) {
            along.push_back((piece.from.along + piece.middle.along) / 2);
            along.push_back((piece.middle.along + piece.to.along) / 2);
        }
        return rings_at(along);
    }

    /// Whether the straight piece is as good as the curve between its ends. @param first, last  its quarters
    bool is_fine(const Piece& piece, const Ring& first, const Ring& last) const {
        const auto& [a, middle, b] = piece;
        const double step = b.along - a.along;
        if (detail_.skin && step * kRingsPerBone * tuft_.joints > 1) return false;
        const double turn =
            curve_.turning_until(b.along * curve_.arc_length()) - curve_.turning_until(a.along * curve_.arc_length());
        const double twist = std::abs(tuft_.twist_deg) * kRadiansPerDegree * step;
        if (turn > kLargestTurn || twist > kLargestTurn) return false;
        const double widest = std::max({a.half_width, middle.half_width, b.half_width});
        const double side_error = widest * (turn * turn + twist * twist) / 8;  // sagitta of an arc
        const double allowed = kLookedAt * detail_.tolerance - side_error;
        // An S crosses its chord in the middle, so the quarters are looked at too.
        return error_at(a, middle, b, 0.5) <= allowed && error_at(a, first, b, 0.25) <= allowed &&
               error_at(a, last, b, 0.75) <= allowed;
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
    const Vectors vectors_;
};

}  // namespace

Result<Rings> choose_rings(const Curve& curve, const Tuft& tuft, double diameter, const MeshDetail& detail,
                           const Limits& limits, Vectors vectors) {
    const RingChooser chooser(curve, tuft, diameter, detail, vectors);
    if (detail.rings) return chooser.by_count(*detail.rings);
    if (std::optional<Rings> rings = chooser.by_tolerance(limits.rings_per_tuft)) return *std::move(rings);
    return Error{ErrorCode::kTooMany,
                 "",
                 detail.tolerance,
                 "a tuft of at most " + std::to_string(limits.rings_per_tuft) +
                     " rings; use a larger mesh.tolerance or set mesh.rings",
                 {},
                 {}};
}

}  // namespace tuftwave
