#pragma once

#include <cstddef>

namespace tuftwave::server::memory {

/// What is put by for when memory runs out, bytes, twice: to let go of the largest list of a request, 600,000 numbers,
/// takes 9.6 million. Nobody writes to it, so that it costs addresses and no memory.
inline constexpr std::size_t kReserveBytes = 16 * 1024 * 1024;

/// Puts the reserve by if it is not there. One half is given up when an allocation fails, so that what runs then can
/// end; the other one when an allocation fails while an exception lets go of what it passes. Without it a failing
/// allocation could end the process, since destructors may not throw and nlohmann::json's allocates. Call it before
/// work that takes memory. Thread-safe.
/// @throws std::bad_alloc  if there is no memory for it: the work must not be begun
void hold_reserve();

/// Whether all of it is there. Thread-safe.
bool has_reserve();

}  // namespace tuftwave::server::memory
