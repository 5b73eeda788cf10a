#include "memory/buffers.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <mutex>
#include <utility>

namespace tuftwave::server::memory {
namespace {

using Clock = std::chrono::steady_clock;

/// The largest one that may be used for so much: else small answers would hold the memory of large ones.
constexpr std::size_t most_for(const std::size_t room) { return room + room / 4; }

struct Kept {
    std::string buffer;
    Clock::time_point since;

    bool is_free() const { return buffer.capacity() < kLeastBuffer; }  // a string always has a little room of its own
};

// One for the whole process, as the C library's own are: no answer depends on what is in it.
std::mutex mutex;  // guards what follows; nothing is allocated or freed while it is held
std::array<Kept, 4> all;
std::size_t most_kept = kUsuallyKept;

std::size_t bytes_of(const Kept& kept) { return kept.is_free() ? 0 : kept.buffer.capacity(); }

/// One that fits, the smallest of them; an empty string if there is none, and then nothing is kept either, so that what
/// waits and what is new are never there together.
std::string found(const std::size_t room) {
    std::array<Kept, 4> dropped;  // freed behind the lock
    const std::lock_guard lock(mutex);
    Kept* best = nullptr;
    for (Kept& kept : all) {
        const std::size_t capacity = bytes_of(kept);
        if (capacity < room || capacity > most_for(room)) continue;
        if (best == nullptr || capacity < best->buffer.capacity()) best = &kept;
    }
    if (best != nullptr) return std::exchange(best->buffer, {});
    std::swap(all, dropped);
    return {};
}

/// Bytes that are there already stay what they are; what comes behind them may be anything. `buffer` has the room.
void set_size(std::string& buffer, const std::size_t size) {
#ifdef __cpp_lib_string_resize_and_overwrite
    buffer.resize_and_overwrite(size, [](char*, const std::size_t all_of_it) { return all_of_it; });
#else
    buffer.resize(size);  // zeros, which whoever takes it writes over
#endif
}

/// Large pages take a fifth of the time until all are there. Only a hint: where there are none it changes nothing.
void ask_for_large_pages(const std::string& buffer) {
#ifdef MADV_HUGEPAGE
    const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    const auto begin = (reinterpret_cast<std::uintptr_t>(buffer.data()) + page - 1) / page * page;
    const auto end = (reinterpret_cast<std::uintptr_t>(buffer.data()) + buffer.capacity()) / page * page;
    if (end > begin) ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

}  // namespace

std::string take_buffer(const std::size_t size, std::size_t room) {
    room = std::max(size, room);
    std::string buffer;
    if (room >= kLeastBuffer) buffer = found(room);
    if (buffer.capacity() < room) {
        buffer.reserve(room);
        if (room >= kLeastBuffer) ask_for_large_pages(buffer);
    }
    set_size(buffer, size);
    return buffer;
}

void give_back(std::string buffer) noexcept {
    if (buffer.capacity() < kLeastBuffer) return;
    const std::lock_guard lock(mutex);
    std::size_t bytes = buffer.capacity();
    for (const Kept& kept : all) bytes += bytes_of(kept);
    const auto place = std::find_if(all.begin(), all.end(), [](const Kept& kept) { return kept.is_free(); });
    if (bytes > most_kept || place == all.end()) return;
    place->buffer = std::move(buffer);
    place->since = Clock::now();
}

void keep_at_most(const std::size_t bytes) noexcept {
    const std::lock_guard lock(mutex);
    most_kept = bytes;
}

void free_idle_buffers(const Clock::duration idle) noexcept {
    std::array<Kept, 4> dropped;  // freed behind the lock
    const std::lock_guard lock(mutex);
    const auto now = Clock::now();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i].is_free() && now - all[i].since >= idle) std::swap(all[i], dropped[i]);
    }
}

std::size_t kept_bytes() {
    const std::lock_guard lock(mutex);
    std::size_t bytes = 0;
    for (const Kept& kept : all) bytes += bytes_of(kept);
    return bytes;
}

}  // namespace tuftwave::server::memory
