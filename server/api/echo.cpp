#include "api/echo.hpp"

namespace tuftwave::server {

std::variant<std::monostate, double, std::string> echo(const JsonValue value) {
    if (const auto number = value.number()) return *number;
    if (const auto text = value.text()) return std::string(text->substr(0, kLongestEcho));
    if (const auto flag = value.boolean()) return std::string(*flag ? "true" : "false");
    return std::string(value.is_null() ? "null" : value.is_array() ? "array" : "object");
}

}  // namespace tuftwave::server
