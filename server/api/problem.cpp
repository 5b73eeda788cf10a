#include "api/problem.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "tuftwave/limits.hpp"

namespace tuftwave::server {
namespace {

constexpr std::size_t kUsualBytes = 512;

struct Row {
    ProblemCode code;
    const char* slug;
    int status;
    const char* sentence;  // without what JSON would escape
};

/// The one table of errors; openapi.yaml lists the same slugs.
constexpr std::array<Row, 34> kTable{{
    {ProblemCode::kMalformed, "malformed", 400, "The body is not well-formed."},
    {ProblemCode::kDuplicateKey, "duplicate_key", 400, "A key occurs twice in one object."},
    {ProblemCode::kTooDeep, "too_deep", 400, "The body is nested too deeply."},
    {ProblemCode::kTooManyValues, "too_many_values", 413, "The body holds too many values."},
    {ProblemCode::kMissingField, "missing_field", 422, "A required field is missing."},
    {ProblemCode::kUnknownField, "unknown_field", 422, "There is no field of this name here."},
    {ProblemCode::kWrongType, "wrong_type", 422, "A field has the wrong type."},
    {ProblemCode::kNotAChoice, "not_a_choice", 422, "A field is not one of its choices."},
    {ProblemCode::kNotFinite, "not_finite", 422, "A number is not finite."},
    {ProblemCode::kOutOfRange, "out_of_range", 422, "A value is out of range."},
    {ProblemCode::kTooFew, "too_few", 422, "There are too few of something."},
    {ProblemCode::kTooMany, "too_many", 422, "There are too many of something."},
    {ProblemCode::kDegenerate, "degenerate", 422, "The geometry has no direction or no length where it needs one."},
    {ProblemCode::kConflict, "conflict", 422, "Two values exclude each other."},
    {ProblemCode::kUndefinedAsPrinted, "undefined_as_printed", 422,
     "The formula as printed in the paper has no result here."},
    {ProblemCode::kUnsupported, "unsupported", 422, "The file needs something that is not supported."},
    {ProblemCode::kUnauthorized, "unauthorized", 401, "This needs a valid key, sent as Authorization: Bearer."},
    {ProblemCode::kNotFound, "not_found", 404, "There is nothing here."},
    {ProblemCode::kMethodNotAllowed, "method_not_allowed", 405, "This method is not allowed here."},
    {ProblemCode::kNotAcceptable, "not_acceptable", 406, "None of the accepted formats is available."},
    {ProblemCode::kTooSlow, "too_slow", 408, "The request did not arrive in time."},
    {ProblemCode::kLengthRequired, "length_required", 411, "The request needs a Content-Length."},
    {ProblemCode::kTooLarge, "too_large", 413, "The body is too large."},
    {ProblemCode::kUriTooLong, "uri_too_long", 414, "The request target is too long."},
    {ProblemCode::kUnsupportedMediaType, "unsupported_media_type", 415,
     "The body is of a type that is not understood."},
    {ProblemCode::kExpectationFailed, "expectation_failed", 417, "Only 100-continue can be expected here."},
    {ProblemCode::kOverShare, "over_share", 429, "This key has used up its share; try again later."},
    {ProblemCode::kHeadersTooLarge, "headers_too_large", 431, "The request's headers are too large."},
    {ProblemCode::kBadRequest, "bad_request", 400, "The request is not valid HTTP."},
    {ProblemCode::kNotImplemented, "not_implemented", 501,
     "This method is not known; GET, HEAD, POST and OPTIONS are."},
    {ProblemCode::kVersionNotSupported, "version_not_supported", 505, "Only HTTP/1.1 and HTTP/1.0 are spoken here."},
    {ProblemCode::kBusy, "busy", 503, "The server is full; try again shortly."},
    {ProblemCode::kDeadline, "deadline", 504, "The computation took longer than allowed."},
    {ProblemCode::kInternal, "internal", 500, "Something went wrong on our side."},
}};

const Row& row(ProblemCode code) {
    for (const Row& candidate : kTable) {
        if (candidate.code == code) return candidate;
    }
    return kTable.back();
}

ProblemCode code_of(ErrorCode code) {
    switch (code) {
        case ErrorCode::kNotFinite:
            return ProblemCode::kNotFinite;
        case ErrorCode::kOutOfRange:
            return ProblemCode::kOutOfRange;
        case ErrorCode::kTooFew:
            return ProblemCode::kTooFew;
        case ErrorCode::kTooMany:
            return ProblemCode::kTooMany;
        case ErrorCode::kDegenerate:
            return ProblemCode::kDegenerate;
        case ErrorCode::kConflict:
            return ProblemCode::kConflict;
        case ErrorCode::kUndefinedAsPrinted:
            return ProblemCode::kUndefinedAsPrinted;
        case ErrorCode::kCancelled:
            return ProblemCode::kDeadline;
    }
    return ProblemCode::kInternal;
}

std::string value_text(const FieldProblem& field) {
    if (const auto* number = std::get_if<double>(&field.value)) return to_text(*number);
    if (const auto* text = std::get_if<std::string>(&field.value)) return "\"" + *text + "\"";
    return "";
}

/// One sentence: what, where, what was given, what is allowed.
std::string describe(const FieldProblem& field) {
    std::string text = row(field.code).sentence;
    text.pop_back();
    const std::string value = value_text(field);
    if (!value.empty()) text += ": " + value;
    if (!field.allowed.empty()) text += "; allowed is " + field.allowed;
    return text + ".";
}

nlohmann::ordered_json to_json(const FieldProblem& field) {
    nlohmann::ordered_json json{
        {"code", row(field.code).slug}, {"pointer", field.pointer}, {"detail", describe(field)}};
    if (const auto* number = std::get_if<double>(&field.value)) json["value"] = *number;
    if (const auto* text = std::get_if<std::string>(&field.value)) json["value"] = *text;
    if (!field.allowed.empty()) json["allowed"] = field.allowed;
    if (field.minimum) json["minimum"] = *field.minimum;
    if (field.maximum) json["maximum"] = *field.maximum;
    return json;
}

std::string dumped(const nlohmann::ordered_json& json) {
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

const char* slug(ProblemCode code) { return row(code).slug; }

int status(ProblemCode code) { return row(code).status; }

Problem fields_problem(std::vector<FieldProblem> fields) {
    Problem problem;
    problem.code = fields.front().code;
    const std::string where = fields.front().pointer.empty() ? "the body" : fields.front().pointer;
    problem.detail = "At " + where + ": " + describe(fields.front());
    problem.fields = std::move(fields);
    return problem;
}

FieldProblem to_field_problem(const Error& error, const std::string& place) {
    return {code_of(error.code), place + error.field, error.given, error.allowed, error.minimum, error.maximum};
}

Problem to_problem(const Error& error, const std::string& place) {
    if (error.code == ErrorCode::kCancelled) return {ProblemCode::kDeadline, "", {}, {}};
    return fields_problem({to_field_problem(error, place)});
}

Response to_response(const Problem& problem, const std::string& request_id) {
    const Row& known = row(problem.code);
    // Piece by piece: an overloaded server writes thousands in a second, most of them without details.
    std::string body;
    body.reserve(kUsualBytes);
    body.append(R"({"type":"urn:tuftwave:problem:)").append(known.slug);
    body.append(R"(","title":")").append(known.sentence);
    body.append(R"(","status":)").append(std::to_string(known.status));
    if (problem.detail.empty()) {
        body.append(R"(,"detail":")").append(known.sentence).append(R"(")");
    } else {
        body.append(R"(,"detail":)").append(dumped(problem.detail));
    }
    body.append(R"(,"request_id":")").append(request_id).append(R"(")");
    if (!problem.fields.empty()) {
        auto errors = nlohmann::ordered_json::array();
        for (const FieldProblem& field : problem.fields) errors.push_back(to_json(field));
        body.append(R"(,"errors":)").append(dumped(errors));
    }
    body += '}';
    Response response{known.status, "application/problem+json", std::move(body), problem.headers};
    response.headers.emplace_back("Cache-Control", "no-store");
    return response;
}

}  // namespace tuftwave::server
