// Based on: our own.
#include "tuftwave/wide.hpp"

#include <array>
#include <cstddef>

namespace tuftwave {
namespace {

constexpr std::array kAll{Vectors::kNarrow, Vectors::kWide, Vectors::kWidest};

std::size_t count_usable() {
#if defined(__x86_64__) && defined(__GNUC__)
    if (__builtin_cpu_supports("avx2") == 0) return 1;
    // Those with VBMI2 came later than the ones that slow down for vectors of eight.
    const bool has_widest = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                            __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
                            __builtin_cpu_supports("avx512vbmi2") != 0;
    return has_widest ? 3 : 2;
#else
    return 1;
#endif
}

}  // namespace

std::span<const Vectors> usable_vectors() {
    static const std::size_t count = count_usable();
    return std::span(kAll).first(count);
}

}  // namespace tuftwave
