#pragma once

#include <optional>
#include <string_view>

namespace tuftwave::server {

/// A file that was built into the program, by its name: "openapi.yaml", "studio/index.html". Lives as long as the
/// program.
std::optional<std::string_view> asset(std::string_view name);

}  // namespace tuftwave::server
