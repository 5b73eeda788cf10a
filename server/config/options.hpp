#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "config/config.hpp"

namespace tuftwave::server {

/// One option: everything that is said about it, once. Its default is the field's own.
struct Option {
    std::string_view name;      ///< of the flag, and the key in a file
    std::string_view also_env;  ///< a second environment variable, behind TUFTWAVE_NAME; "" if none
    std::variant<int Config::*, double Config::*, std::string Config::*> field;
    double minimum, maximum;   ///< of a number, or of a text's length
    std::string_view choices;  ///< of a text: "a|b|c"; "" if any text of that length
    std::string_view unit;
    std::string_view help;
};

std::span<const Option> options();

/// The option of that name, or nothing.
const Option* find_option(std::string_view name);

/// Its environment variables, the strongest first.
std::vector<std::string> environment_names(const Option& option);

/// What may be given, for people: "a whole number from 0 to 65535".
std::string allowed(const Option& option);

/// The field's value as text.
std::string value_text(const Option& option, const Config& config);

/// Sets the field. @return  false if the text is not allowed; the configuration is then unchanged
[[nodiscard]] bool set(const Option& option, std::string_view text, Config& config);

/// The candidate that is at most two typing errors away, or nothing.
std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace tuftwave::server
