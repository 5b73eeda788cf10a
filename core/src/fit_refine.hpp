#pragma once

#include <optional>
#include <vector>

#include "drawn_plane.hpp"
#include "normal_equations.hpp"
#include "wave_unknowns.hpp"

namespace tuftwave {

/// How far a wave's nodes are from the drawn ones, and how that changes with the unknowns.
struct Misfit {
    double cost = 0;               ///< sum of squares
    NormalEquations<5> equations;  ///< of the step that a linear problem would need
};

/// Brings a wave nearer to a drawing, step by step: the damped least squares of Levenberg and Marquardt.
class Refinement {
  public:
    /// @param plane, bounds  outlive the refinement
    /// @param lightness      s, where it is given and not looked for
    Refinement(const DrawnPlane& plane, const WaveBounds& bounds, const WaveUnknowns& start,
               std::optional<double> lightness);

    /// Tries one change; the cost never grows. Does nothing once it has settled.
    void step();

    bool is_settled() const { return is_settled_; }
    double cost() const { return misfit_.cost; }
    const WaveUnknowns& unknowns() const { return unknowns_; }

    /// The standard deviation of the droop, as far as the remaining distances tell; infinite where it is not
    /// determined.
    double droop_deviation() const;

  private:
    WaveUnknowns tied(WaveUnknowns unknowns) const;
    std::optional<WaveUnknowns> change() const;

    const DrawnPlane* plane_;
    const WaveBounds* bounds_;
    std::optional<double> lightness_;
    WaveUnknowns unknowns_;
    Misfit misfit_;
    double damping_;
    bool is_settled_ = false;
};

/// @param lightness  s, where the droop hangs on the swing
Misfit measure_misfit(const DrawnPlane& plane, const WaveUnknowns& unknowns, std::optional<double> lightness);

}  // namespace tuftwave
