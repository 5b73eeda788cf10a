#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tuftwave/math.hpp"
#include "tuftwave/wide.hpp"

namespace tuftwave {

struct PlaceSearch;

namespace bezier {
struct Velocity;
}

/// A place on a curve: the point, the unit tangent, and a unit normal that does not spin about the tangent.
struct CurveFrame {
    Vec3 point;
    Vec3 tangent;
    Vec3 normal;  ///< perpendicular to the tangent

    Vec3 binormal() const { return cross(tangent, normal); }
};

/// Many frames, quantity by quantity: x, y and z of the points, of the tangents and of the normals.
struct FrameRows {
    double* first;
    std::size_t stride;  ///< from row to row, doubles

    void set(std::size_t i, const CurveFrame& frame) const {
        set_vector(0, i, frame.point);
        set_vector(1, i, frame.tangent);
        set_normal(i, frame.normal);
    }
    void set_normal(std::size_t i, const Vec3& normal) const { set_vector(2, i, normal); }

  private:
    TUFTWAVE_BODY void set_vector(std::size_t quantity, std::size_t i, const Vec3& v) const {
        double* const at = first + 3 * quantity * stride + i;
        at[0] = v.x;
        at[stride] = v.y;
        at[2 * stride] = v.z;
    }
};

/// A composite cubic Bezier through points, measured by arc length, with rotation-minimising frames.
class Curve {
  public:
    /// @param points  at least 2, of which at least two are further apart than 1e-9 of the whole length; points
    ///                nearer than that to the one before are merged into it
    /// Cost O(points). Thread-safe. Deterministic.
    /// Source: centripetal Catmull-Rom tangents (Yuksel et al. 2011); frames by double reflection (Wang et al. 2008).
    /// @param vectors  which change nothing but the time
    explicit Curve(std::span<const Vec3> points, Vectors vectors = widest_vectors());

    /// Arc length from the first point to the last, metres.
    double arc_length() const { return samples_.back().along; }

    /// The frames of the first point and of the last.
    const CurveFrame& first() const { return samples_.front().frame; }
    const CurveFrame& last() const { return samples_.back().frame; }

    /// The frame at arc length `along`, clamped to the curve.
    CurveFrame at(double along) const;

    /// The frames at many arc lengths, as many in `out`; quickest where they rise.
    void at(std::span<const double> along, std::span<CurveFrame> out) const;

    /// The angle the tangent turns through from the start up to `along`, radians, never falling.
    double turning_until(double along) const;

    /// Where shares of length and turning together are reached, so that equal parts are shorter in bends; quickest
    /// where they rise.
    /// @param parts       0 to 1
    /// @param turn_worth  metres of length that a turn by one radian counts for, >= 0
    /// @param along, out  as many arc lengths, metres, and the frames there; `along` may be `parts`
    void at_parts(std::span<const double> parts, double turn_worth, std::span<double> along,
                  const FrameRows& out) const;

    /// Turns every normal about its tangent by the same angle, so that on the whole they point away from `center`.
    void face_away_from(const Vec3& center);

  private:
    struct Segment {
        Vec3 start, end;
        Vec3 constant, linear, quadratic;  // of its velocity

        bezier::Velocity velocity() const;
        Vec3 point(double t) const;

        /// The parameter in [t0, t1] with `wanted` metres between it and t0, of `whole` up to t1.
        double parameter(double t0, double t1, double wanted, double whole) const;
    };
    struct Heading {
        Vec3 tangent;
        double speed;
    };
    /// A place where a piece of a segment ends.
    struct Sample {
        std::size_t segment;
        double from, t;            // parameters of the piece's ends
        double from_speed, speed;  // there
        double along;              // arc length up to here
        double turning;            // angle turned up to here
        CurveFrame frame;
    };
    struct FirstSamples;
    struct Pieces;

    void make_segments(std::span<const Vec3> points);
    void measure();
    // `last` is the heading at the last sample, kept at hand: what was just stored takes long to be read again.
    void measure(std::size_t segment, const FirstSamples& first, std::size_t k, Heading& last);
    void sample_up_to(std::size_t segment, double from, double t, const Heading& between, const Heading& end,
                      int halvings, Heading& last);
    void add_sample(std::size_t segment, double from, double t, const Heading& end, double arc, double turn,
                    Heading& last);
    void find_unknown_arcs();
    void carry_normals();
    Heading heading_at(std::size_t segment, double t, const Vec3& otherwise) const;
    std::size_t sample_before(double along, std::size_t guess) const;
    void find(std::span<const double> along, std::span<const std::size_t> pieces, PlaceSearch& places) const;

    Vectors vectors_;
    std::vector<Segment> segments_;
    std::vector<Sample> samples_;
};

}  // namespace tuftwave
