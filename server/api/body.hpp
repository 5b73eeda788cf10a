#pragma once

#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>
#include <variant>

#include "api/exchange.hpp"
#include "api/json_guard.hpp"
#include "api/problem.hpp"

namespace tuftwave::server {

/// A request's JSON body.
/// @return  the document, unsupported_media_type, or what parse_guarded says
std::variant<nlohmann::json, Problem> read_body(const Request& request);

/// Refuses query parameters that nobody asked for or that come twice. @return  nothing, unknown_field or duplicate_key
std::optional<Problem> check_query(const Request& request, std::initializer_list<std::string_view> known);

}  // namespace tuftwave::server
