#pragma once

#include <cstddef>
#include <string>
#include <variant>

#include "api/json_value.hpp"

namespace tuftwave::server {

inline constexpr std::size_t kLongestEcho = 64;  ///< bytes of a client's string that go back in a problem

/// A scalar as it goes back in a problem; of an array or object only what it is.
std::variant<std::monostate, double, std::string> echo(JsonValue value);

}  // namespace tuftwave::server
