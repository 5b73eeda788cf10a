#pragma once

#include "bezier.hpp"
#include "tuftwave/curve.hpp"

/// What all files of Curve have inlined.
namespace tuftwave {

inline bezier::Velocity Curve::Segment::velocity() const { return {constant, linear, quadratic}; }

inline Vec3 Curve::Segment::point(double t) const { return t == 1 ? end : start + velocity().way_to(t); }

}  // namespace tuftwave
