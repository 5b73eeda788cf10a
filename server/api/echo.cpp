#include "api/echo.hpp"

#include <nlohmann/json.hpp>

namespace tuftwave::server {

using nlohmann::json;

std::variant<std::monostate, double, std::string> echo(const json& value) {
    if (const auto* number = value.get_ptr<const json::number_float_t*>()) return *number;
    if (const auto* natural = value.get_ptr<const json::number_unsigned_t*>()) return static_cast<double>(*natural);
    if (const auto* integer = value.get_ptr<const json::number_integer_t*>()) return static_cast<double>(*integer);
    if (const auto* text = value.get_ptr<const json::string_t*>()) return text->substr(0, kLongestEcho);
    if (const auto* flag = value.get_ptr<const json::boolean_t*>()) return std::string(*flag ? "true" : "false");
    return std::string(value.type_name());
}

std::optional<double> as_number(const json& value) {
    if (!value.is_number()) return {};
    const auto echoed = echo(value);
    return std::get<double>(echoed);
}

}  // namespace tuftwave::server
