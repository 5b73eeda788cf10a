#pragma once

#include <optional>
#include <string>
#include <variant>

namespace tuftwave::server::character {

/// Why an uploaded file cannot be used.
struct Fault {
    enum class Kind { kMalformed, kMissing, kWrongType, kOutOfRange, kTooMany, kConflict, kDegenerate, kUnsupported };

    Kind kind = Kind::kMalformed;
    std::string pointer;  ///< JSON pointer into the file's glTF; "" is the file itself
    std::variant<std::monostate, double, std::string> given;
    std::string allowed;  ///< for people; of a malformed file, what is wrong with it
    std::optional<double> minimum, maximum;
};

}  // namespace tuftwave::server::character
