#pragma once

#include <cstddef>
#include <cstdint>

#include "tuftwave/wide.hpp"

namespace tuftwave {

/// Of large output: as far ahead as is written while memory answers.
inline constexpr std::size_t kAheadBytes = 4096;

/// Has the memory fetched that is written kAheadBytes after these; computing goes on meanwhile. A hint: what lies
/// there, and whether it may be touched, does not matter.
TUFTWAVE_BODY void fetch_ahead([[maybe_unused]] const void* begin, [[maybe_unused]] std::size_t bytes) {
#if defined(__GNUC__)
    constexpr std::size_t kLine = 64;
    const std::uintptr_t first = reinterpret_cast<std::uintptr_t>(begin) + kAheadBytes;
    for (std::size_t at = 0; at < bytes; at += kLine) __builtin_prefetch(reinterpret_cast<const void*>(first + at), 1);
#endif
}

}  // namespace tuftwave
