#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "api/exchange.hpp"
#include "tuftwave/result.hpp"

namespace tuftwave::server {

/// Everything that can go wrong, for a whole request or for one field. The table in problem.cpp gives each its slug,
/// status and sentence.
enum class ProblemCode {
    kMalformed,
    kDuplicateKey,
    kTooDeep,
    kTooManyValues,
    kMissingField,
    kUnknownField,
    kWrongType,
    kNotAChoice,
    kNotFinite,
    kOutOfRange,
    kTooFew,
    kTooMany,
    kDegenerate,
    kConflict,
    kUndefinedAsPrinted,
    kUnsupported,
    kUnauthorized,
    kNotFound,
    kMethodNotAllowed,
    kNotAcceptable,
    kTooSlow,
    kLengthRequired,
    kTooLarge,
    kUriTooLong,
    kUnsupportedMediaType,
    kExpectationFailed,
    kOverShare,
    kHeadersTooLarge,
    kBadRequest,
    kNotImplemented,
    kVersionNotSupported,
    kBusy,
    kDeadline,
    kInternal,
};

/// What is wrong with one field.
struct FieldProblem {
    ProblemCode code = ProblemCode::kOutOfRange;
    std::string pointer;  ///< JSON pointer into the body, or "?name" for a query parameter
    std::variant<std::monostate, double, std::string> value;
    std::string allowed;
    std::optional<double> minimum, maximum;
};

/// Why there is no answer.
struct Problem {
    ProblemCode code = ProblemCode::kInternal;
    std::string detail;  ///< for this occurrence; the table's sentence when empty
    std::vector<FieldProblem> fields;
    NameValues headers;  ///< Allow, Retry-After, WWW-Authenticate
};

/// A problem made of what is wrong with fields. @param fields  at least one
Problem fields_problem(std::vector<FieldProblem> fields);

/// Core's reason as a field's problem. @param place  JSON pointer of the struct that core was given
FieldProblem to_field_problem(const Error& error, const std::string& place);

/// Core's reason as a whole problem; a cancelled computation is past its deadline.
Problem to_problem(const Error& error, const std::string& place = "");

const char* slug(ProblemCode code);
int status(ProblemCode code);

/// The problem as application/problem+json (RFC 9457). @param request_id  without what JSON would escape
Response to_response(const Problem& problem, const std::string& request_id);

}  // namespace tuftwave::server
