// Based on: our own.
#include "tuftwave/wide.hpp"

namespace tuftwave {

bool has_wide_vectors() {
#if defined(__x86_64__) && defined(__GNUC__)
    static const bool has_them = __builtin_cpu_supports("avx2") != 0;
    return has_them;
#else
    return false;
#endif
}

Vectors widest_vectors() { return has_wide_vectors() ? Vectors::kWide : Vectors::kNarrow; }

}  // namespace tuftwave
