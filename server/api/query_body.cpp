#include "api/query_body.hpp"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace tuftwave::server {
namespace {

std::optional<double> number_in(std::string_view text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_number = error == std::errc{} && end == text.data() + text.size() && std::isfinite(number);
    return is_number ? std::optional(number) : std::nullopt;
}

nlohmann::json value_in(const std::string& text) {
    if (text == "true" || text == "false") return text == "true";
    if (const auto number = number_in(text)) return *number;
    nlohmann::json numbers = nlohmann::json::array();
    for (std::string_view rest = text; text.find(',') != std::string::npos;) {
        const std::size_t end = rest.find(',');
        const auto number = number_in(rest.substr(0, end));
        if (!number) return text;
        numbers.push_back(*number);
        if (end == std::string_view::npos) return numbers;
        rest.remove_prefix(end + 1);
    }
    return text;
}

const QueryField* row_of(std::string_view name, std::span<const QueryField> fields) {
    for (const QueryField& field : fields) {
        if (field.name == name) return &field;
    }
    return nullptr;
}

void rename_pointers(std::vector<FieldProblem>& problems, std::span<const QueryField> fields) {
    for (FieldProblem& wrong : problems) {
        for (const QueryField& field : fields) {
            if (wrong.pointer != field.place && !wrong.pointer.starts_with(std::string(field.place) + "/")) continue;
            wrong.pointer = "?" + std::string(field.name);
            break;
        }
    }
}

/// Gives what was of a wrong type as it stands in the query.
void quote(std::vector<FieldProblem>& problems, const Request& request) {
    constexpr std::size_t kLongest = 64;  // bytes
    for (FieldProblem& wrong : problems) {
        for (const auto& [name, value] : request.query) {
            if (wrong.code == ProblemCode::kWrongType && wrong.pointer == "?" + name)
                wrong.value = value.substr(0, kLongest);
        }
    }
}

/// The problem with a sentence about what its fields say now.
Problem described(Problem problem) {
    Problem anew = fields_problem(std::move(problem.fields));
    anew.headers = std::move(problem.headers);
    return anew;
}

}  // namespace

std::vector<std::string_view> names_of(std::span<const QueryField> fields) {
    std::vector<std::string_view> names{"format"};
    for (const QueryField& field : fields) names.push_back(field.name);
    return names;
}

JsonDocument query_body(const Request& request, std::span<const QueryField> fields) {
    nlohmann::json body = nlohmann::json::object();
    for (const auto& [name, value] : request.query) {
        const QueryField* const row = row_of(name, fields);
        if (row == nullptr) continue;
        nlohmann::json& place = body[nlohmann::json::json_pointer(std::string(row->place))];
        place = row->value == QueryValue::kText ? nlohmann::json(value) : value_in(value);
        if (row->value == QueryValue::kNumbers && place.is_number()) place = nlohmann::json::array({place});
    }
    return JsonDocument::parse(body.dump()).value();
}

Problem as_query_problem(Problem problem, std::span<const QueryField> fields) {
    if (problem.fields.empty()) return problem;
    rename_pointers(problem.fields, fields);
    return described(std::move(problem));
}

Problem as_query_problem(Problem problem, std::span<const QueryField> fields, const Request& request) {
    if (problem.fields.empty()) return problem;
    rename_pointers(problem.fields, fields);
    quote(problem.fields, request);
    return described(std::move(problem));
}

}  // namespace tuftwave::server
