#pragma once

namespace tuftwave::server::gltf {

constexpr int kDoubleTextBytes = 32;  ///< that write_double() writes at most

/// Writes a finite number as nlohmann's to_chars() does, which takes three times as long: with the fewest digits that
/// read back as the same double, and with a point or an exponent.
/// @param to  touched no further than what is written
/// @return  behind what was written
char* write_double(char* to, double value);

}  // namespace tuftwave::server::gltf
