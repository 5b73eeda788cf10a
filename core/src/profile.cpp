// Based on: Shimosoyama, Yamamoto, Noma. NPR Hair Modeling by Controlling the Shape of Tufts. Section 3.2.
// Differs: the paper only says that the diameter grows from 0 to d and shrinks to 0; the four shapes are ours.
#include "tuftwave/profile.hpp"

#include <cmath>

#include "tuftwave/elementary.hpp"
#include "tuftwave/math.hpp"

namespace tuftwave {
namespace {

/// The rise from 0 to 1. @param part  0 to 1
double rise(Taper taper, double part) {
    switch (taper) {
        case Taper::kSine:
            return elementary::sin(kPi / 2 * part);
        case Taper::kLinear:
            return part;
        case Taper::kSmooth:
            return part * part * (3 - 2 * part);
        case Taper::kRound:
            return std::sqrt(part * (2 - part));
    }
    return part;
}

}  // namespace

double profile_width(Taper taper, double along, double widest_at) {
    if (along <= 0) return 0;
    if (along <= widest_at) return rise(taper, along / widest_at);
    if (along >= 1) return 0;
    return rise(taper, (1 - along) / (1 - widest_at));
}

}  // namespace tuftwave
