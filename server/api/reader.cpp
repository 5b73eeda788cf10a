#include "api/reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <set>

#include "api/echo.hpp"

namespace tuftwave::server {
namespace {

constexpr const char *kThree = "three numbers", *kFour = "four numbers";

/// Unicode characters in UTF-8, which the parser has already checked.
std::size_t characters(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// A natural number from digits alone.
std::optional<std::int64_t> as_natural(std::string_view digits) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || digits.size() > 7 || error != std::errc{} || end != digits.data() + digits.size() ||
        value < 0)
        return {};
    return value;
}

std::optional<FrameRate> as_frame_rate(std::string_view text) {
    const std::size_t stroke = text.find('/');
    const auto numerator = as_natural(text.substr(0, stroke));
    const auto denominator =
        stroke == std::string_view::npos ? std::optional<std::int64_t>(1) : as_natural(text.substr(stroke + 1));
    if (!numerator || !denominator) return {};
    if (*numerator == 0 || *denominator == 0) return FrameRate{*numerator, *denominator};  // for core to refuse
    const std::int64_t divisor = std::gcd(*numerator, *denominator);
    return FrameRate{*numerator / divisor,
                     *denominator / divisor};  // lowest terms, so that a recipe reads back to itself
}

/// One of 64 bits, by which most of the names that are not there can be told without comparing any.
std::uint64_t mark_of(std::string_view name) {
    if (name.empty()) return 1;
    return std::uint64_t{1} << ((name.size() * 7 + static_cast<unsigned char>(name.front()) * 3 +
                                 static_cast<unsigned char>(name.back())) %
                                64);
}

std::optional<double> as_number(const JsonValue value, const Place& place, FieldProblems& problems) {
    const std::optional<double> number = value.number();
    if (!number) problems.add({ProblemCode::kWrongType, place.pointer(), echo(value), "a number", {}, {}});
    return number;
}

std::optional<double> as_whole_number(const JsonValue value, const Place& place, Range range, FieldProblems& problems) {
    const std::optional<double> number = value.number();
    if (!number || *number != std::trunc(*number)) {
        problems.add({ProblemCode::kWrongType, place.pointer(), echo(value), "a whole number", {}, {}});
        return {};
    }
    if (is_within(*number, range)) return number;
    problems.add(to_field_problem(*check_range(*number, range, ""), place.pointer()));
    return {};
}

}  // namespace

Fields::Fields(const JsonValue value, const Place& place, FieldProblems& problems)
    : value_(value), place_(place), problems_(problems) {
    constexpr std::size_t kUsual = 16;  // fields that are asked for
    known_.reserve(kUsual);
    if (!value.is_object()) {
        problems_.add({ProblemCode::kWrongType, place.pointer(), echo(value), "an object", {}, {}});
        return;
    }
    for (const auto& [key, member] : value.members()) marks_ |= mark_of(key);
}

std::optional<JsonValue> Fields::find(std::string_view name) {
    known_.push_back(name);
    if ((marks_ & mark_of(name)) == 0) return {};
    return value_.find(name);
}

std::optional<JsonValue> Fields::find_array(std::string_view name, std::size_t most) {
    const std::optional<JsonValue> value = find(name);
    if (!value) return {};
    if (!value->is_array()) {
        refuse_type(name, *value, "an array");
        return {};
    }
    if (const Check wrong = check_count(value->size(), 0, most, "")) {
        problems_.add(to_field_problem(*wrong, Place(place_, name).pointer()));
        return {};
    }
    return value;
}

void Fields::refuse_type(std::string_view name, const JsonValue value, const std::string& wanted) {
    problems_.add({ProblemCode::kWrongType, Place(place_, name).pointer(), echo(value), wanted, {}, {}});
}

void Fields::refuse_choice(std::string_view name, const JsonValue value, const std::string& words) {
    problems_.add({ProblemCode::kNotAChoice, Place(place_, name).pointer(), echo(value), "one of " + words, {}, {}});
}

void Fields::read(std::string_view name, const JsonValue value, double& into) {
    const std::optional<double> number = value.number();
    if (!number) return refuse_type(name, value, "a number");
    into = *number;
}

void Fields::read(std::string_view name, const JsonValue value, bool& into) {
    const std::optional<bool> flag = value.boolean();
    if (!flag) return refuse_type(name, value, "true or false");
    into = *flag;
}

void Fields::read(std::string_view name, const JsonValue value, std::size_t longest, std::string& into) {
    const std::optional<std::string_view> text = value.text();
    if (!text) return refuse_type(name, value, "a string");
    if (const Check wrong = check_count(characters(*text), 0, longest, ""))
        return problems_.add(to_field_problem(*wrong, Place(place_, name).pointer()));
    into = *text;
}

void Fields::read(std::string_view name, const JsonValue value, Vec3& into) {
    std::array<double, 3> parts{};
    if (!value.read_numbers(parts)) return refuse_numbers(value, Place(place_, name), parts.size(), kThree);
    into = {parts[0], parts[1], parts[2]};
}

void Fields::number(std::string_view name, double& into) {
    if (const auto value = find(name)) read(name, *value, into);
}

void Fields::number(std::string_view name, std::optional<double>& into) {
    const auto value = find_or_empty(name, into);
    if (!value) return;
    if (!into) into = 0;
    read(name, *value, *into);
}

std::optional<double> Fields::whole_number(std::string_view name, const JsonValue value, Range range) {
    return as_whole_number(value, Place(place_, name), range, problems_);
}

void Fields::integer(std::string_view name, Range range, int& into) {
    const auto value = find(name);
    if (!value) return;
    if (const auto number = whole_number(name, *value, range)) into = static_cast<int>(*number);
}

void Fields::integer(std::string_view name, Range range, std::optional<int>& into) {
    const auto value = find_or_empty(name, into);
    if (!value) return;
    if (const auto number = whole_number(name, *value, range)) into = static_cast<int>(*number);
}

void Fields::seed(std::string_view name, std::uint64_t& into) {
    const auto value = find(name);
    if (!value) return;
    if (const auto number = whole_number(name, *value, kSeedRange)) into = static_cast<std::uint64_t>(*number);
}

void Fields::boolean(std::string_view name, bool& into) {
    if (const auto value = find(name)) read(name, *value, into);
}

void Fields::boolean(std::string_view name, std::optional<bool>& into) {
    const auto value = find_or_empty(name, into);
    if (!value) return;
    if (!into) into = false;
    read(name, *value, *into);
}

void Fields::text(std::string_view name, std::size_t longest, std::string& into) {
    if (const auto value = find(name)) read(name, *value, longest, into);
}

void Fields::text(std::string_view name, std::size_t longest, std::optional<std::string>& into) {
    if (const auto value = find_or_empty(name, into)) read(name, *value, longest, into.emplace());
}

void Fields::color(std::string_view name, std::string& into) {
    const auto value = find(name);
    if (!value) return;
    const std::optional<std::string_view> text = value->text();
    const auto is_hexadecimal = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    };
    if (!text || text->size() != 7 || text->front() != '#' ||
        !std::all_of(text->begin() + 1, text->end(), is_hexadecimal))
        return refuse_type(name, *value, "# and six hexadecimal digits");
    into = *text;
}

void Fields::frame_rate(std::string_view name, FrameRate& into) {
    const auto value = find(name);
    if (!value) return;
    if (const std::optional<double> number = value->number()) {
        into = to_frame_rate(*number);
        return;
    }
    const std::optional<std::string_view> text = value->text();
    const auto fraction = text ? as_frame_rate(*text) : std::nullopt;
    if (!fraction) return refuse_type(name, *value, "a number, or a fraction such as \"24000/1001\"");
    into = *fraction;
}

void Fields::refuse_numbers(const JsonValue value, const Place& place, std::size_t width, const char* wanted) {
    if (!value.is_array() || value.size() != width)
        return problems_.add({ProblemCode::kWrongType, place.pointer(), echo(value), wanted, {}, {}});
    std::size_t i = 0;
    for (const JsonValue part : value.items()) {
        if (!as_number(part, Place(place, i++), problems_)) return;
    }
}

void Fields::vector(std::string_view name, Vec3& into) {
    if (const auto value = find(name)) read(name, *value, into);
}

void Fields::vector(std::string_view name, std::optional<Vec3>& into) {
    if (const auto value = find_or_empty(name, into)) read(name, *value, into.emplace());
}

void Fields::rotation(std::string_view name, Quat& into) {
    const auto value = find(name);
    if (!value) return;
    std::array<double, 4> parts{};
    if (!value->read_numbers(parts)) return refuse_numbers(*value, Place(place_, name), parts.size(), kFour);
    into = {parts[0], parts[1], parts[2], parts[3]};
}

void Fields::vectors(std::string_view name, std::size_t most, std::vector<Vec3>& into) {
    items_into(name, most, 1, into, [&](const JsonValue item, const Place& place) {
        std::array<double, 3> parts{};
        if (!item.read_numbers(parts)) return refuse_numbers(item, place, parts.size(), kThree);
        into.push_back({parts[0], parts[1], parts[2]});
    });
}

void Fields::rotations(std::string_view name, std::size_t most, std::vector<Quat>& into) {
    if (const auto value = find(name); value && value->is_null()) return;
    items_into(name, most, 1, into, [&](const JsonValue item, const Place& place) {
        std::array<double, 4> parts{};
        if (!item.read_numbers(parts)) return refuse_numbers(item, place, parts.size(), kFour);
        into.push_back({parts[0], parts[1], parts[2], parts[3]});
    });
}

void Fields::numbers(std::string_view name, std::size_t most, Range range, std::vector<double>& into) {
    items_into(name, most, 1, into, [&](const JsonValue item, const Place& place) {
        const std::optional<double> number = as_number(item, place, problems_);
        if (!number) return;
        if (const Check wrong = check_range(*number, range, ""))
            return problems_.add(to_field_problem(*wrong, place.pointer()));
        into.push_back(*number);
    });
}

bool Fields::has_triples(std::string_view name) {
    const std::optional<JsonValue> value = find(name);
    if (!value || !value->is_array() || value->size() % 3 == 0) return true;  // for find_array() to refuse
    problems_.add({ProblemCode::kWrongType,
                   Place(place_, name).pointer(),
                   static_cast<double>(value->size()),
                   "a list whose length is a multiple of 3",
                   {},
                   {}});
    return false;
}

void Fields::flat_vectors(std::string_view name, std::size_t most, std::vector<Vec3>& into) {
    if (!has_triples(name)) return;
    std::array<double, 3> parts{};
    std::size_t count = 0;
    items_into(name, 3 * most, 3, into, [&](const JsonValue item, const Place& place) {
        const std::optional<double> number = as_number(item, place, problems_);
        if (!number) return;
        parts[count % 3] = *number;
        if (++count % 3 == 0) into.push_back({parts[0], parts[1], parts[2]});
    });
}

void Fields::flat_triples(std::string_view name, std::size_t most, Range range,
                          std::vector<std::array<std::uint32_t, 3>>& into) {
    if (!has_triples(name)) return;
    std::array<std::uint32_t, 3> parts{};
    std::size_t count = 0;
    items_into(name, 3 * most, 3, into, [&](const JsonValue item, const Place& place) {
        const std::optional<double> number = as_whole_number(item, place, range, problems_);
        if (!number) return;
        parts[count % 3] = static_cast<std::uint32_t>(*number);
        if (++count % 3 == 0) into.push_back(parts);
    });
}

void Fields::require(std::string_view name) {
    if (value_.is_object() && !find(name))
        problems_.add({ProblemCode::kMissingField, Place(place_, name).pointer(), {}, "", {}, {}});
}

void Fields::done() {
    if (!value_.is_object()) return;
    std::set<std::string_view> unknown;  // told by name
    for (const auto& [key, value] : value_.members()) {
        if (std::find(known_.begin(), known_.end(), key) == known_.end()) unknown.insert(key);
    }
    if (unknown.empty()) return;
    std::string names;
    for (const std::string_view name : std::set(known_.begin(), known_.end()))
        names += (names.empty() ? "" : ", ") + std::string(name);
    for (const std::string_view key : unknown)
        problems_.add(
            {ProblemCode::kUnknownField, Place(place_, key.substr(0, kLongestEcho)).pointer(), {}, names, {}, {}});
}

}  // namespace tuftwave::server
