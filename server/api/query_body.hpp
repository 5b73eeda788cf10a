#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "api/exchange.hpp"
#include "api/json_value.hpp"
#include "api/problem.hpp"

namespace tuftwave::server {

/// How a parameter's text is read: as what it looks like, as text always, as a list of numbers even if it is one.
enum class QueryValue { kAny, kText, kNumbers };

/// A query parameter, and where it stands in the body that the query stands for.
struct QueryField {
    std::string_view name;
    std::string_view place;  ///< JSON pointer, e.g. "/timing/period"
    QueryValue value = QueryValue::kAny;
};

/// The names of the parameters, and "format".
std::vector<std::string_view> names_of(std::span<const QueryField> fields);

/// The query as the body it stands for: "0.5" becomes a number, "1,0,0" an array of them, "true" a boolean, anything
/// else is text. So a setting is read and refused alike wherever it comes from. Parameters that have no row are left
/// out.
JsonDocument query_body(const Request& request, std::span<const QueryField> fields);

/// A problem found in such a body, with the query's names: "/timing/period" is "?period" again.
Problem as_query_problem(Problem problem, std::span<const QueryField> fields);

/// The same, and what was of a wrong type is quoted as it stands in the query.
Problem as_query_problem(Problem problem, std::span<const QueryField> fields, const Request& request);

}  // namespace tuftwave::server
