#pragma once

#include <array>
#include <cstdint>

namespace tuftwave {

/// What a random number is for: the third word of Philox's counter. Part of the API's promise, see openapi.yaml.
enum class RandomUse : std::uint32_t { kAlong = 0, kCrown = 1, kNeck = 2, kPhase = 3 };

/// Philox4x32-10: ten rounds of the counter-based generator.
/// @return  four independent, uniform 32-bit words
/// Deterministic; the same counter and key give the same words on every machine.
std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// A uniform number in [0, 1) with 53 random bits, from the words `first` and `second`.
double unit_interval(std::uint32_t first, std::uint32_t second);

}  // namespace tuftwave
