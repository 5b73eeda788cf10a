#pragma once

#include <utility>

/// Vector code without intrinsics: a plain loop over small arrays, written once as an inline body and compiled twice,
/// for every CPU that the program runs on and for those with vectors of four doubles. Neither contracts or reorders, so
/// both give the same bits.
#if defined(__x86_64__) && defined(__GNUC__)
#define TUFTWAVE_WIDE [[gnu::target("avx2")]]
#else
#define TUFTWAVE_WIDE
#endif

/// What a body, and every function that it calls, is declared with; one that is not inlined stays narrow.
#define TUFTWAVE_BODY [[gnu::always_inline]] inline

namespace tuftwave {

/// Which of a body's two compilations runs.
enum class Vectors { kNarrow, kWide };

/// Whether this CPU and its system have what wide compilations use.
bool has_wide_vectors();

/// The widest that this machine runs.
Vectors widest_vectors();

template <auto kBody, class... Arguments>
TUFTWAVE_WIDE void run_wide(Arguments&&... arguments) {
    kBody(std::forward<Arguments>(arguments)...);
}

/// Calls `kBody`, a function declared TUFTWAVE_BODY that returns nothing.
/// @param vectors  wide only on a CPU that has them
template <auto kBody, class... Arguments>
void run_with(Vectors vectors, Arguments&&... arguments) {
    if (vectors == Vectors::kWide) return run_wide<kBody>(std::forward<Arguments>(arguments)...);
    kBody(std::forward<Arguments>(arguments)...);
}

}  // namespace tuftwave
