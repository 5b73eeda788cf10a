#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "api/exchange.hpp"
#include "api/json_guard.hpp"
#include "api/problem.hpp"

namespace tuftwave::server {

/// Refuses a body of another media type than these, or one that is packed. @return  nothing or unsupported_media_type
std::optional<Problem> check_media_type(const Request& request, std::initializer_list<std::string_view> understood);

/// A request's JSON body.
/// @return  the document, unsupported_media_type, or what parse_guarded says
std::variant<JsonDocument, Problem> read_body(const Request& request);

/// Refuses query parameters that nobody asked for, that come twice or that are not UTF-8.
/// @return  nothing, unknown_field, duplicate_key or wrong_type
std::optional<Problem> check_query(const Request& request, const std::vector<std::string_view>& known);

}  // namespace tuftwave::server
