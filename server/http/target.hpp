#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "api/exchange.hpp"

namespace tuftwave::server {

/// A request's target, decoded.
struct Target {
    std::string path;
    NameValues query;  ///< in the order sent
};

/// @param target  as sent: "/v1/tufts?format=glb"
/// @return  nothing if it is not an absolute path in visible ASCII, has a fragment, is badly percent-encoded, or if the
///          path has an encoded NUL
std::optional<Target> parse_target(std::string_view target);

}  // namespace tuftwave::server
