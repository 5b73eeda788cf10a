#pragma once

#include <array>
#include <string_view>

namespace tuftwave::server {

using Digest = std::array<unsigned char, 32>;

/// SHA-256 of some bytes. Throws std::bad_alloc, or std::runtime_error if OpenSSL has none.
Digest sha256(std::string_view bytes);

/// Compares in a time that does not depend on where they differ.
bool equal_in_constant_time(const Digest& a, const Digest& b);

}  // namespace tuftwave::server
