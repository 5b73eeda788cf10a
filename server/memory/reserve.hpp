#pragma once

#include <cstddef>

namespace tuftwave::server::memory {

/// What is put by for when memory runs out, bytes: to let go of the largest list of a request, 600,000 numbers, takes
/// 9.6 million. Nobody writes to it, so that it costs addresses and no memory.
inline constexpr std::size_t kReserveBytes = 16 * 1024 * 1024;

/// Puts the reserve by if it is not there, to be given up when an allocation fails: what runs then can end, and what it
/// holds can be let go. Without it a failing allocation could end the process, since destructors may not throw and
/// nlohmann::json's allocates. Call it before work that takes memory. Thread-safe.
/// @throws std::bad_alloc  if there is no memory for it: the work must not be begun
void hold_reserve();

/// Whether it is there. Thread-safe.
bool has_reserve();

}  // namespace tuftwave::server::memory
