#include "memory/reserve.hpp"

#include <sys/mman.h>

#include <atomic>
#include <exception>
#include <mutex>
#include <new>

#include "memory/buffers.hpp"

namespace tuftwave::server::memory {
namespace {

using Half = std::atomic<void*>;

Half to_go_on = nullptr, to_let_go = nullptr;
std::atomic<unsigned> given_up = 0;  // times
thread_local unsigned seen = 0;      // of these, those that this thread has tried again after

// Not by malloc, which would take the next large blocks from where this one was.
void hold(Half& half) {
    if (half.load(std::memory_order_relaxed) != nullptr) return;
    void* const block = mmap(nullptr, kReserveBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (block == MAP_FAILED) throw std::bad_alloc();
    void* expected = nullptr;
    if (!half.compare_exchange_strong(expected, block)) munmap(block, kReserveBytes);  // another thread was faster
}

bool give_up(Half& half) {
    void* const block = half.exchange(nullptr);
    if (block == nullptr) return false;
    munmap(block, kReserveBytes);
    ++given_up;
    return true;
}

/// What operator new calls when there is no memory; if it returns, operator new tries again.
void make_room() {
    if (kept_bytes() > 0) return free_idle_buffers(std::chrono::seconds(0));
    if (!give_up(to_go_on) && std::uncaught_exceptions() > 0) give_up(to_let_go);
    const unsigned times = given_up;
    if (times == seen) throw std::bad_alloc();
    seen = times;  // where another thread has just given something up, there is something to be had, too
}

}  // namespace

void hold_reserve() {
    static std::once_flag once;
    std::call_once(once, [] { std::set_new_handler(make_room); });
    hold(to_go_on);
    hold(to_let_go);
}

bool has_reserve() {
    return to_go_on.load(std::memory_order_relaxed) != nullptr && to_let_go.load(std::memory_order_relaxed) != nullptr;
}

}  // namespace tuftwave::server::memory
