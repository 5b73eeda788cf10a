#include "memory/heap.hpp"

#include <malloc.h>

#include <atomic>

namespace tuftwave::server::memory {
namespace {

using Clock = std::chrono::steady_clock;

std::atomic<Clock::rep> given_back_at = 0;  // ticks of the clock

}  // namespace

void set_up_heap() {
    ::mallopt(M_MMAP_THRESHOLD, static_cast<int>(kOwnPagesBytes));
    ::mallopt(M_TRIM_THRESHOLD, static_cast<int>(kKeptByThread));
}

void give_back_free_heap(const Clock::duration interval) noexcept {
    const Clock::rep now = Clock::now().time_since_epoch().count();
    Clock::rep before = given_back_at.load(std::memory_order_relaxed);
    if (now - before < interval.count() || !given_back_at.compare_exchange_strong(before, now)) return;
    ::malloc_trim(0);
}

}  // namespace tuftwave::server::memory
