#pragma once

#include "byte_source.hpp"
#include "tuftwave/schedule.hpp"

namespace tuftwave::server::fuzz {

/// A timing that may have a schedule or not. @param fps  given, or 0 for any
inline Timing any_timing(ByteSource& source, const std::int64_t fps = 0) {
    Timing timing;
    timing.period = source.number(0.01, 4);
    timing.fps = {source.integer(1, 240), source.integer(1, 3)};
    if (fps != 0) timing.fps = {fps, 1};
    timing.hold = source.integer(1, 24);
    timing.short_holds = source.byte() % 2 == 0 ? ShortHolds::kLast : ShortHolds::kSpread;
    timing.sampling = source.byte() % 2 == 0 ? Sampling::kUniform : Sampling::kByFrame;
    return timing;
}

}  // namespace tuftwave::server::fuzz
