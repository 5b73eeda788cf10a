#include "tuftwave/limits.hpp"

#include <charconv>
#include <cmath>
#include <utility>

namespace tuftwave {
namespace {

Error out_of(ErrorCode code, double value, Range range, std::string_view field, std::string allowed) {
    return {code, std::string(field), value, std::move(allowed), range.minimum, range.maximum};
}

std::string span_text(Range range) { return to_text(range.minimum) + " to " + to_text(range.maximum); }

}  // namespace

std::string to_text(double value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    return {digits, end};
}

Check check_range(double value, Range range, std::string_view field) {
    if (is_within(value, range)) return {};
    const ErrorCode code = std::isfinite(value) ? ErrorCode::kOutOfRange : ErrorCode::kNotFinite;
    return out_of(code, value, range, field, span_text(range));
}

Check check_magnitude(double value, Range range, std::string_view field) {
    if (is_within(value < 0 ? -value : value, range)) return {};
    const Range below{-range.maximum, -range.minimum};
    const ErrorCode code = std::isfinite(value) ? ErrorCode::kOutOfRange : ErrorCode::kNotFinite;
    return out_of(code, value, {below.minimum, range.maximum}, field, span_text(range) + " or " + span_text(below));
}

Check check_count(std::size_t count, std::size_t minimum, std::size_t maximum, std::string_view field) {
    if (count >= minimum && count <= maximum) return {};
    const Range range{static_cast<double>(minimum), static_cast<double>(maximum)};
    return out_of(count < minimum ? ErrorCode::kTooFew : ErrorCode::kTooMany, static_cast<double>(count), range, field,
                  span_text(range));
}

Check check_total(std::size_t total, std::size_t most, std::string_view what, std::string_view field) {
    if (total <= most) return {};
    std::string allowed = "at most " + std::to_string(most) + " ";
    allowed += what;
    const auto given = static_cast<double>(total), maximum = static_cast<double>(most);
    return Error{ErrorCode::kTooMany, std::string(field), given, std::move(allowed), {}, maximum};
}

}  // namespace tuftwave
