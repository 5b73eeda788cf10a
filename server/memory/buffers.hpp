#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace tuftwave::server::memory {

/// What is smaller is left to the C library, which keeps it by itself.
inline constexpr std::size_t kLeastBuffer = 1024 * 1024;
/// Bytes of buffers that wait to be used again, at most, unless keep_at_most() says otherwise: a large answer or a few,
/// and all of it is free in a second.
inline constexpr std::size_t kUsuallyKept = 96 * 1024 * 1024;

/// A string of `size` bytes, whatever is in them, that can grow to `room` bytes without moving. Whoever takes it
/// overwrites all of it, since it may be what somebody else gave back: fresh pages cost ten times what writing costs.
/// Thread-safe.
/// @throws std::bad_alloc
std::string take_buffer(std::size_t size, std::size_t room);

/// Keeps a large buffer for whoever takes one next; frees one that is small or too much. Thread-safe.
void give_back(std::string buffer) noexcept;

/// Sets how many bytes of buffers wait at most; those that wait already stay. Thread-safe.
void keep_at_most(std::size_t bytes) noexcept;

/// Frees what nobody has taken for so long; all of it when an allocation fails (reserve.hpp). Thread-safe.
void free_idle_buffers(std::chrono::steady_clock::duration idle = std::chrono::seconds(1)) noexcept;

/// Bytes that are kept now. Thread-safe.
std::size_t kept_bytes();

}  // namespace tuftwave::server::memory
