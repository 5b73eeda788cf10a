#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace tuftwave {

/// What can be wrong with a request that is otherwise well formed.
enum class ErrorCode {
    kNotFinite,           ///< a number is infinite or not a number
    kOutOfRange,          ///< a value lies outside its range
    kTooFew,              ///< a list is too short
    kTooMany,             ///< a list, or what would be made from it, is too long
    kDegenerate,          ///< the geometry has no direction or no length where it needs one
    kConflict,            ///< two values exclude each other
    kUndefinedAsPrinted,  ///< the papers' printed formula has no result here
    kCancelled,           ///< the stop token was set
};

/// One thing that is wrong: where, what was given, what is allowed.
struct Error {
    ErrorCode code = ErrorCode::kOutOfRange;
    std::string field;  ///< JSON pointer below the struct that was checked, e.g. "/points/3/1"; "" is the struct itself
    std::variant<std::monostate, double, std::string> given;
    std::string allowed;  ///< for people, e.g. "1 to 100"
    std::optional<double> minimum;
    std::optional<double> maximum;
};

/// Puts a struct's own place in front of an error's field, so that "/period" becomes "/motion/timing/period".
inline Error within(const std::string& place, Error error) {
    error.field.insert(0, place);
    return error;
}

/// A value or the reason why there is none. Bad input never throws.
template <class T>
class [[nodiscard]] Result {
  public:
    Result(T&& value) : content_(std::in_place_index<0>, std::move(value)) {}
    Result(const T& value) : content_(std::in_place_index<0>, value) {}
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

    explicit operator bool() const { return content_.index() == 0; }
    const T& value() const& { return std::get<0>(content_); }
    T& value() & { return std::get<0>(content_); }
    T&& value() && { return std::get<0>(std::move(content_)); }
    const T& operator*() const& { return value(); }
    T& operator*() & { return value(); }
    const T* operator->() const { return &value(); }
    T* operator->() { return &value(); }
    const Error& error() const { return std::get<1>(content_); }

  private:
    std::variant<T, Error> content_;
};

/// Nothing, or the reason why not.
using Check = std::optional<Error>;

}  // namespace tuftwave
