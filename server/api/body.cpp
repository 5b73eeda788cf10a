#include "api/body.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace tuftwave::server {
namespace {

/// The media type without its parameters, in lower case.
std::string media_type(const std::string& header) {
    std::string type = header.substr(0, header.find(';'));
    while (!type.empty() && type.back() == ' ') type.pop_back();
    for (char& c : type) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return type;
}

/// Bodies are checked by their parser, queries by nobody else.
bool is_utf8(const std::string& text) {
    try {
        return !nlohmann::json(text).dump().empty();
    } catch (const nlohmann::json::type_error&) {
        return false;
    }
}

}  // namespace

std::optional<Problem> check_media_type(const Request& request, std::initializer_list<std::string_view> understood) {
    std::string types;
    for (const std::string_view type : understood) types += (types.empty() ? "" : ", ") + std::string(type);
    const std::string& encoding = request.header("content-encoding");
    if (!encoding.empty() && encoding != "identity")
        return Problem{ProblemCode::kUnsupportedMediaType,
                       "Content-Encoding is not understood; send the body as it is.",
                       {},
                       {{"Accept", types}}};
    const std::string type = media_type(request.header("content-type"));
    if (std::find(understood.begin(), understood.end(), type) != understood.end()) return {};
    return Problem{
        ProblemCode::kUnsupportedMediaType, "Send the body with Content-Type: " + types + ".", {}, {{"Accept", types}}};
}

std::variant<JsonDocument, Problem> read_body(const Request& request) {
    if (auto problem = check_media_type(request, {"application/json"})) return *std::move(problem);
    return parse_guarded(request.body, JsonLimits{});
}

std::optional<Problem> check_query(const Request& request, const std::vector<std::string_view>& known) {
    std::vector<std::string_view> seen;
    for (const auto& [name, value] : request.query) {
        if (std::find(seen.begin(), seen.end(), name) != seen.end())
            return fields_problem(
                {{ProblemCode::kDuplicateKey, "?" + name.substr(0, 64), {}, "each parameter once", {}, {}}});
        seen.push_back(name);
        const bool is_known = std::find(known.begin(), known.end(), name) != known.end();
        if (is_known && !is_utf8(value))
            return fields_problem(
                {{ProblemCode::kWrongType, "?" + name, value.substr(0, 64), "text in UTF-8", {}, {}}});
        if (is_known) continue;
        std::string names;
        for (const std::string_view word : known) names += (names.empty() ? "" : ", ") + std::string(word);
        return fields_problem({{ProblemCode::kUnknownField, "?" + name.substr(0, 64), {}, names, {}, {}}});
    }
    return {};
}

}  // namespace tuftwave::server
