// What the memory allows: the same number of bytes set and copied in memory that is used again, and written for the
// first time.
//
//   tuftwave_bench_memory BYTES
#include <sys/mman.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "measure.hpp"

int main(int count, char** arguments) {
    using namespace tuftwave::bench;
    if (count != 2) return std::fputs("usage: tuftwave_bench_memory BYTES\n", stderr), 2;
    const std::size_t bytes = std::strtoull(arguments[1], nullptr, 10);
    std::vector<char> from(bytes, 1), to(bytes, 2);
    measure("memset", [&] {
        std::memset(to.data(), 3, bytes);
        keep(to.data());
    });
    measure("memcpy", [&] {
        std::memcpy(to.data(), from.data(), bytes);
        keep(to.data());
    });
    measure("fresh_write", [&] {
        void* fresh = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (fresh == MAP_FAILED) std::abort();
        std::memset(fresh, 4, bytes);
        keep(fresh);
        munmap(fresh, bytes);
    });
}
