#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tuftwave/curve.hpp"

namespace tuftwave {

/// One ring of a tuft, ready to be meshed.
struct Ring {
    CurveFrame frame;       ///< normal already turned by roll and twist
    double along;           ///< share of the arc length
    double half_width;      ///< along the frame's binormal, metres
    double half_thickness;  ///< along the frame's normal, metres
};

/// Some rings, quantity by quantity, so that loops over them take whole vectors.
class Rings {
  public:
    Rings() = default;
    /// @param count  rings, all zero
    explicit Rings(std::size_t count) : count_(count), rows_(kRows * count) {}

    std::size_t size() const { return count_; }
    bool empty() const { return count_ == 0; }

    TUFTWAVE_BODY Ring operator[](std::size_t i) const {
        const double* const at = rows_.data() + i;
        return {{{at[0], at[count_], at[2 * count_]},
                 {at[3 * count_], at[4 * count_], at[5 * count_]},
                 {at[6 * count_], at[7 * count_], at[8 * count_]}},
                at[9 * count_],
                at[10 * count_],
                at[11 * count_]};
    }

    FrameRows frames() { return {rows_.data(), count_}; }
    std::span<double> along() { return row(9); }
    std::span<double> half_widths() { return row(10); }
    std::span<double> half_thicknesses() { return row(11); }
    std::span<const double> along() const { return row(9); }
    std::span<const double> half_widths() const { return row(10); }

    void set(std::size_t i, const Ring& ring) {
        frames().set(i, ring.frame);
        along()[i] = ring.along;
        half_widths()[i] = ring.half_width;
        half_thicknesses()[i] = ring.half_thickness;
    }

  private:
    static constexpr std::size_t kRows = 12;

    std::span<double> row(std::size_t k) { return std::span(rows_).subspan(k * count_, count_); }
    std::span<const double> row(std::size_t k) const { return std::span(rows_).subspan(k * count_, count_); }

    std::size_t count_ = 0;
    std::vector<double> rows_;
};

}  // namespace tuftwave
