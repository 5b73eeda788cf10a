#include "memory.hpp"

#include <sys/mman.h>

#include <cstring>
#include <stdexcept>
#include <vector>

#include "measure.hpp"

namespace tuftwave::bench {

void measure_memory(const std::string& work, std::size_t bytes) {
    std::vector<char> from(bytes, 1), to(bytes, 2);
    measure(work + "/memset", [&] {
        std::memset(to.data(), 3, bytes);
        keep(to.data());
    });
    measure(work + "/memcpy", [&] {
        std::memcpy(to.data(), from.data(), bytes);
        keep(to.data());
    });
    measure(work + "/fresh_write", [&] {
        void* fresh = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (fresh == MAP_FAILED) throw std::runtime_error("no memory to write");
        std::memset(fresh, 4, bytes);
        keep(fresh);
        munmap(fresh, bytes);
    });
}

}  // namespace tuftwave::bench
