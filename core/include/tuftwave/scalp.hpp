#pragma once

#include <optional>
#include <utility>
#include <variant>

#include "tuftwave/head.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/triangle_tree.hpp"

namespace tuftwave {

/// A scalp made ready for questions, in the head's frame.
class Scalp {
  public:
    /// The head's scalp.
    /// @param head  checked
    /// @return  nothing for a head without one
    static std::optional<Scalp> of(const Head& head);

    /// How far from the head's center the scalp lies, where a ray last meets it.
    /// @param direction  unit, in the head's frame
    /// @return  metres; nothing where a mesh has no surface there
    /// Thread-safe. Deterministic.
    std::optional<double> distance_towards(const Vec3& direction) const;

    /// The way from a point inside to a place on the surface that is near, the nearest on a mesh. Under a chin or
    /// behind a neck a point can be outside although the surface comes again further out.
    /// @param point  in the head's frame, metres
    /// @return  metres; nothing where the point is outside
    std::optional<Vec3> way_out(const Vec3& point) const;

  private:
    struct Ellipsoid {
        Vec3 center, radii;  // in the head's frame
    };
    using Surface = std::variant<Ellipsoid, TriangleTree>;

    explicit Scalp(Surface surface) : surface_(std::move(surface)) {}

    static std::optional<Vec3> way_out_of(const Ellipsoid& ellipsoid, const Vec3& point);
    static std::optional<Vec3> way_out_of(const TriangleTree& tree, const Vec3& point);

    Surface surface_;
};

}  // namespace tuftwave
