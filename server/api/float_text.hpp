#pragma once

namespace tuftwave::server {

constexpr int kFloatTextBytes = 24;  ///< that write_float() may touch

/// Writes a finite number with the fewest digits that read back as the same float, in the form that nlohmann's dump()
/// gives the double of those digits: with a point or an exponent, 15 places before the point or 4 behind it at most.
/// @param to  with room for kFloatTextBytes
/// @return  behind what was written
char* write_float(char* to, float value);

}  // namespace tuftwave::server
