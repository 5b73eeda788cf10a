// Based on: Shimosoyama, Yamamoto, Noma. NPR Hair Modeling by Controlling the Shape of Tufts. Section 3.2.
// Differs: the paper only says that the diameter grows from 0 to d and shrinks to 0; the four shapes are ours.
#include "tuftwave/profile.hpp"

#include <cmath>
#include <cstddef>

#include "elementary_bodies.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/wide.hpp"

namespace tuftwave {
namespace {

/// The rise from 0 to 1. @param part  0 to 1
template <Taper kTaper>
TUFTWAVE_BODY double rise(double part) {
    switch (kTaper) {
        case Taper::kSine:
            return elementary::bodies::sincos(kPi / 2 * part).sin;
        case Taper::kLinear:
            return part;
        case Taper::kSmooth:
            return part * part * (3 - 2 * part);
        case Taper::kRound:
            return std::sqrt(part * (2 - part));
    }
    return part;
}

template <Taper kTaper>
TUFTWAVE_BODY void widths(std::span<const double> along, double widest_at, std::span<double> out) {
    for (std::size_t i = 0; i < along.size(); ++i) {
        const double before = along[i] > 0 ? along[i] / widest_at : 0;
        const double after = along[i] < 1 ? (1 - along[i]) / (1 - widest_at) : 0;
        out[i] = rise<kTaper>(along[i] <= widest_at ? before : after);
    }
}

}  // namespace

double profile_width(Taper taper, double along, double widest_at) {
    double width;
    profile_widths(taper, {&along, 1}, widest_at, {&width, 1});
    return width;
}

void profile_widths(Taper taper, std::span<const double> along, double widest_at, std::span<double> out,
                    Vectors vectors) {
    switch (taper) {
        case Taper::kSine:
            return run_with<widths<Taper::kSine>>(vectors, along, widest_at, out);
        case Taper::kLinear:
            return run_with<widths<Taper::kLinear>>(vectors, along, widest_at, out);
        case Taper::kSmooth:
            return run_with<widths<Taper::kSmooth>>(vectors, along, widest_at, out);
        case Taper::kRound:
            return run_with<widths<Taper::kRound>>(vectors, along, widest_at, out);
    }
}

}  // namespace tuftwave
