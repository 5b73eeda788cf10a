#include "memory/heap.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace tuftwave::server::memory {
namespace {

constexpr std::size_t kBytes = 4'000'000;  // less than is kept
const auto page_bytes = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));

/// Takes a request's temporaries, writes to them and frees them.
/// @return  bytes for which the system had to be asked
std::size_t fetched() {
    const auto faults = [] {
        rusage usage{};
        ::getrusage(RUSAGE_THREAD, &usage);
        return static_cast<std::size_t>(usage.ru_minflt);
    };
    const std::size_t before = faults();
    {
        std::vector<std::string> all;
        for (int i = 0; i < 400; ++i) all.emplace_back(kBytes / 400, 'x');
    }
    return (faults() - before) * page_bytes;
}

std::size_t resident() {
    std::size_t all = 0, pages = 0;
    std::ifstream("/proc/self/statm") >> all >> pages;
    return pages * page_bytes;
}

struct Heap : testing::Test {
    Heap() { set_up_heap(); }
    void SetUp() override {
        if (TUFTWAVE_SANITIZED) GTEST_SKIP() << "a sanitizer has an allocator of its own";
    }
};

TEST_F(Heap, KeepsWhatOneRequestTakesForTheNextOne) {
    fetched();
    EXPECT_LT(fetched(), kBytes / 10);
}

TEST_F(Heap, GivesBackWhatIsKept) {
    fetched();
    const std::size_t before = resident();
    give_back_free_heap(std::chrono::seconds(0));
    EXPECT_LT(resident() + kBytes / 2, before);
}

TEST_F(Heap, GivesBackOnceInAnInterval) {
    give_back_free_heap(std::chrono::seconds(0));
    fetched();
    give_back_free_heap(std::chrono::hours(1));
    EXPECT_LT(fetched(), kBytes / 10);
}

}  // namespace
}  // namespace tuftwave::server::memory
