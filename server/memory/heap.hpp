#pragma once

#include <chrono>
#include <cstddef>

namespace tuftwave::server::memory {

/// A block so large that does not fit into what is kept has pages of its own, which go back when it is freed.
inline constexpr std::size_t kOwnPagesBytes = 1024 * 1024;
/// Bytes of free memory that each thread keeps at the end of its heap, at most: what most requests take besides their
/// answer. To fetch fresh pages takes longer than to write to them.
inline constexpr std::size_t kKeptByThread = 8 * 1024 * 1024;

/// Has the C library do so. By itself it learns to keep up to 64 MiB, and without learning it keeps 128 KiB, so that
/// each request fetches its pages anew. For the begin of a program, before there are threads.
void set_up_heap();

/// Gives back to the system what all threads keep, and whole free pages between what is used, unless it was done a
/// moment ago. Thread-safe.
/// @param interval  between two times; zero for now
void give_back_free_heap(std::chrono::steady_clock::duration interval = std::chrono::seconds(1)) noexcept;

}  // namespace tuftwave::server::memory
