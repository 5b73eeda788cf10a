#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <variant>

namespace tuftwave::server {

inline constexpr std::size_t kLongestEcho = 64;  ///< bytes of a client's string that go back in a problem

/// A scalar as it goes back in a problem; of an array or object only what it is.
std::variant<std::monostate, double, std::string> echo(const nlohmann::json& value);

/// A number of any JSON kind; nothing where the value is none.
std::optional<double> as_number(const nlohmann::json& value);

}  // namespace tuftwave::server
