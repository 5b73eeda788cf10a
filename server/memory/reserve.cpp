#include "memory/reserve.hpp"

#include <sys/mman.h>

#include <atomic>
#include <mutex>
#include <new>

namespace tuftwave::server::memory {
namespace {

std::atomic<void*> reserve = nullptr;
std::atomic<unsigned> given_up = 0;  // times
thread_local unsigned seen = 0;      // of these, those that this thread has tried again after

/// What operator new calls when there is no memory; if it returns, operator new tries again.
void give_up_reserve() {
    if (void* const block = reserve.exchange(nullptr)) {
        munmap(block, kReserveBytes);
        ++given_up;
    }
    const unsigned times = given_up;
    if (times == seen) throw std::bad_alloc();
    seen = times;  // where another thread has just given it up, there is something to be had, too
}

}  // namespace

void hold_reserve() {
    static std::once_flag once;
    std::call_once(once, [] { std::set_new_handler(give_up_reserve); });
    if (has_reserve()) return;
    // Not by malloc, which would take the next large blocks from where this one was.
    void* const block = mmap(nullptr, kReserveBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (block == MAP_FAILED) throw std::bad_alloc();
    void* expected = nullptr;
    if (!reserve.compare_exchange_strong(expected, block)) munmap(block, kReserveBytes);  // another thread was faster
}

bool has_reserve() { return reserve.load(std::memory_order_relaxed) != nullptr; }

}  // namespace tuftwave::server::memory
