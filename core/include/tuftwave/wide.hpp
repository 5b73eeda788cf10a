#pragma once

#include <span>
#include <utility>

/// Vector code without intrinsics: a plain loop over small arrays, written once as an inline body and compiled for
/// every CPU that the program runs on, for those with vectors of four doubles and for those with vectors of eight. None
/// of them contracts or reorders, so all give the same bits.
#if defined(__x86_64__) && defined(__GNUC__)
#define TUFTWAVE_WIDE [[gnu::target("avx2")]]
#if defined(__clang__)
#define TUFTWAVE_WIDEST [[gnu::target("avx2,avx512f,avx512dq,avx512vl,avx512bw")]]
#else
#define TUFTWAVE_WIDEST [[gnu::target("avx2,avx512f,avx512dq,avx512vl,avx512bw,prefer-vector-width=512")]]
#endif
#else
#define TUFTWAVE_WIDE
#define TUFTWAVE_WIDEST
#endif

/// What a body, and every function that it calls, is declared with; one that is not inlined stays narrow.
#define TUFTWAVE_BODY [[gnu::always_inline]] inline

namespace tuftwave {

/// Which of a body's compilations runs.
enum class Vectors { kNarrow, kWide, kWidest };

/// Those that this CPU and its system run, the narrowest first.
std::span<const Vectors> usable_vectors();

/// The last of them.
inline Vectors widest_vectors() { return usable_vectors().back(); }

template <auto kBody, class... Arguments>
TUFTWAVE_WIDE void run_wide(Arguments&&... arguments) {
    kBody(std::forward<Arguments>(arguments)...);
}

template <auto kBody, class... Arguments>
TUFTWAVE_WIDEST void run_widest(Arguments&&... arguments) {
    kBody(std::forward<Arguments>(arguments)...);
}

/// Calls `kBody`, a function declared TUFTWAVE_BODY that returns nothing.
/// @param vectors  one of usable_vectors()
template <auto kBody, class... Arguments>
void run_with(Vectors vectors, Arguments&&... arguments) {
    if (vectors == Vectors::kWidest) return run_widest<kBody>(std::forward<Arguments>(arguments)...);
    if (vectors == Vectors::kWide) return run_wide<kBody>(std::forward<Arguments>(arguments)...);
    kBody(std::forward<Arguments>(arguments)...);
}

}  // namespace tuftwave
