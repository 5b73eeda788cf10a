#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <new>

#include "memory/reserve.hpp"

/// Makes operator new fail, in the one program that includes this: it replaces the global operators.
namespace tuftwave::failing {

/// Which allocations fail, of those that have at least so many bytes, counted from 0 over all threads.
struct Plan {
    std::size_t first = SIZE_MAX, last = SIZE_MAX;
    std::size_t least_bytes = 0;
    std::size_t bytes_from_reserve = 0;  ///< that may still be had after the reserve was given up, whatever the numbers
    bool is_short_for_who_lets_go = false;  ///< where an exception passes, only the first allocation fails
};

inline Plan plan;
inline std::atomic<bool> is_armed = false, has_failed_letting_go = false;
inline std::atomic<std::size_t> made = 0, taken_from_reserve = 0;

/// While it lives, what the plan says fails. Without a plan nothing fails and allocations are only counted.
class Armed {
  public:
    explicit Armed(const Plan& what = {}) {
        plan = what;
        made = 0;
        taken_from_reserve = 0;
        has_failed_letting_go = false;
        is_armed = true;
    }
    ~Armed() { is_armed = false; }
    Armed(const Armed&) = delete;
    Armed& operator=(const Armed&) = delete;

    std::size_t count() const { return made; }
};

inline bool fails(const std::size_t bytes) {
    if (!is_armed || bytes < plan.least_bytes) return false;
    if (plan.is_short_for_who_lets_go && std::uncaught_exceptions() > 0) return !has_failed_letting_go.exchange(true);
    const std::size_t number = made++;
    if (number < plan.first || number > plan.last) return false;
    if (plan.bytes_from_reserve == 0 || server::memory::has_reserve()) return true;
    return (taken_from_reserve += bytes) > plan.bytes_from_reserve;
}

/// As the standard has it: where there is no memory, the handler is called, and may make some.
template <class Take>
void* allocate(const std::size_t bytes, const Take take) {
    for (;;) {
        void* const memory = fails(bytes) ? nullptr : take();
        if (memory != nullptr) return memory;
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) throw std::bad_alloc();
        handler();
    }
}

inline void* allocate(const std::size_t bytes) {
    return allocate(bytes, [=] { return std::malloc(bytes == 0 ? 1 : bytes); });
}

inline void* allocate(const std::size_t bytes, const std::align_val_t alignment) {
    const auto unit = static_cast<std::size_t>(alignment);
    return allocate(bytes, [=] { return std::aligned_alloc(unit, (bytes + unit - 1) / unit * unit); });
}

inline void* or_null(const std::size_t bytes) noexcept {
    try {
        return allocate(bytes);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

}  // namespace tuftwave::failing

// NOLINTBEGIN: the operators as the standard has them
void* operator new(std::size_t bytes) { return tuftwave::failing::allocate(bytes); }
void* operator new[](std::size_t bytes) { return tuftwave::failing::allocate(bytes); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept { return tuftwave::failing::or_null(bytes); }
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept { return tuftwave::failing::or_null(bytes); }
void* operator new(std::size_t bytes, std::align_val_t unit) { return tuftwave::failing::allocate(bytes, unit); }
void* operator new[](std::size_t bytes, std::align_val_t unit) { return tuftwave::failing::allocate(bytes, unit); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
// NOLINTEND
