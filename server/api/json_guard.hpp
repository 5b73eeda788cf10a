#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <variant>

#include "api/json_value.hpp"
#include "api/problem.hpp"

namespace tuftwave::server {

/// What a request body may be, before anybody looks at what it says.
struct JsonLimits {
    std::size_t bytes = 16 * 1024 * 1024;  ///< 131,072 points of 64 bytes and 16,384 tufts of 256 bytes make 12 MiB
    std::size_t depth = 32;
    std::size_t values = 2'000'000;  ///< 131,072 points are 524,288 values, 16,384 tufts 262,144, a scalp 1,200,000
    std::size_t keys_per_object = 64;
    bool has_escaped_keys = false;          ///< ours need none; exporters that keep to ASCII write them
    std::size_t memory = 80 * 1024 * 1024;  ///< bytes of the document by our reckoning; those of the largest request
                                            ///< that makes sense are 67 MB
};

/// Parses a client's JSON if its size, nesting, number of values, what they cost and its keys are as they may be. A
/// deep document would overflow the stack of whoever copies or prints it, so it never becomes one.
/// @return  the document, or malformed, duplicate_key, too_deep, too_many_values, too_large
/// What is as usual is parsed at 1 GB/s; what is not, and what is wrong, is looked at byte by byte.
std::variant<JsonDocument, Problem> parse_guarded(std::string_view body, const JsonLimits& limits);

/// The same as a document that can be changed, in which keys keep the order in which they came.
std::variant<nlohmann::ordered_json, Problem> parse_guarded_in_order(std::string_view body, const JsonLimits& limits);

}  // namespace tuftwave::server
