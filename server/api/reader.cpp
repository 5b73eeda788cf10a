#include "api/reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "api/echo.hpp"

namespace tuftwave::server {
namespace {

using nlohmann::json;

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

std::optional<double> as_whole_number(const json& value, const Place& place, Range range, FieldProblems& problems) {
    const std::optional<double> number = as_number(value);
    if (!number || *number != std::trunc(*number)) {
        problems.add({ProblemCode::kWrongType, place.pointer(), echo(value), "a whole number", {}, {}});
        return {};
    }
    if (const Check wrong = check_range(*number, range, "")) {
        problems.add(to_field_problem(*wrong, place.pointer()));
        return {};
    }
    return number;
}

}  // namespace

Fields::Fields(const json& value, const Place& place, FieldProblems& problems)
    : value_(value), place_(place), problems_(problems) {
    if (!value.is_object()) problems_.add({ProblemCode::kWrongType, place.pointer(), echo(value), "an object", {}, {}});
}

const json* Fields::find(std::string_view name) {
    known_.insert(name);
    if (!value_.is_object()) return nullptr;
    const auto at = value_.find(name);
    return at == value_.end() ? nullptr : &*at;
}

bool Fields::is_null(std::string_view name) {
    const json* value = find(name);
    return value != nullptr && value->is_null();
}

void Fields::refuse_type(std::string_view name, const json& value, const std::string& wanted) {
    problems_.add({ProblemCode::kWrongType, Place(place_, name).pointer(), echo(value), wanted, {}, {}});
}

void Fields::refuse_choice(std::string_view name, const json& value, const std::string& words) {
    problems_.add({ProblemCode::kNotAChoice, Place(place_, name).pointer(), echo(value), "one of " + words, {}, {}});
}

void Fields::number(std::string_view name, double& into) {
    const json* value = find(name);
    if (value == nullptr) return;
    const std::optional<double> number = as_number(*value);
    if (!number) return refuse_type(name, *value, "a number");
    into = *number;
}

void Fields::number(std::string_view name, std::optional<double>& into) {
    if (is_null(name)) return into.reset();
    double number = into.value_or(0);
    this->number(name, number);
    if (find(name) != nullptr) into = number;
}

std::optional<double> Fields::whole_number(std::string_view name, Range range) {
    const json* value = find(name);
    if (value == nullptr) return {};
    return as_whole_number(*value, Place(place_, name), range, problems_);
}

void Fields::integer(std::string_view name, Range range, int& into) {
    if (const auto number = whole_number(name, range)) into = static_cast<int>(*number);
}

void Fields::integer(std::string_view name, Range range, std::optional<int>& into) {
    if (is_null(name)) return into.reset();
    if (const auto number = whole_number(name, range)) into = static_cast<int>(*number);
}

void Fields::seed(std::string_view name, std::uint64_t& into) {
    if (const auto number = whole_number(name, kSeedRange)) into = static_cast<std::uint64_t>(*number);
}

void Fields::boolean(std::string_view name, bool& into) {
    const json* value = find(name);
    if (value == nullptr) return;
    const auto* flag = value->get_ptr<const json::boolean_t*>();
    if (flag == nullptr) return refuse_type(name, *value, "true or false");
    into = *flag;
}

void Fields::boolean(std::string_view name, std::optional<bool>& into) {
    if (is_null(name)) return into.reset();
    bool flag = into.value_or(false);
    boolean(name, flag);
    if (find(name) != nullptr) into = flag;
}

void Fields::text(std::string_view name, std::size_t longest, std::optional<std::string>& into) {
    if (is_null(name)) return into.reset();
    if (find(name) != nullptr) text(name, longest, into.emplace());
}

void Fields::text(std::string_view name, std::size_t longest, std::string& into) {
    const json* value = find(name);
    if (value == nullptr) return;
    const auto* text = value->get_ptr<const json::string_t*>();
    if (text == nullptr) return refuse_type(name, *value, "a string");
    if (const Check wrong = check_count(characters(*text), 0, longest, ""))
        return problems_.add(to_field_problem(*wrong, Place(place_, name).pointer()));
    into = *text;
}

void Fields::color(std::string_view name, std::string& into) {
    const json* value = find(name);
    if (value == nullptr) return;
    const auto* text = value->get_ptr<const json::string_t*>();
    const auto is_hexadecimal = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    };
    if (text == nullptr || text->size() != 7 || text->front() != '#' ||
        !std::all_of(text->begin() + 1, text->end(), is_hexadecimal))
        return refuse_type(name, *value, "# and six hexadecimal digits");
    into = *text;
}

void Fields::frame_rate(std::string_view name, FrameRate& into) {
    const json* value = find(name);
    if (value == nullptr) return;
    if (const std::optional<double> number = as_number(*value)) {
        into = to_frame_rate(*number);
        return;
    }
    const auto* text = value->get_ptr<const json::string_t*>();
    const auto fraction = text == nullptr ? std::nullopt : as_frame_rate(*text);
    if (!fraction) return refuse_type(name, *value, "a number, or a fraction such as \"24000/1001\"");
    into = *fraction;
}

template <std::size_t width>
bool Fields::numbers(const json& value, const Place& place, const char* wanted, std::array<double, width>& into) {
    if (!value.is_array() || value.size() != width) {
        problems_.add({ProblemCode::kWrongType, place.pointer(), echo(value), wanted, {}, {}});
        return false;
    }
    for (std::size_t i = 0; i < width; ++i) {
        const std::optional<double> number = as_number(value[i]);
        if (!number) {
            problems_.add({ProblemCode::kWrongType, Place(place, i).pointer(), echo(value[i]), "a number", {}, {}});
            return false;
        }
        into[i] = *number;
    }
    return true;
}

void Fields::vector(std::string_view name, Vec3& into) {
    std::array<double, 3> parts{};
    const json* value = find(name);
    if (value == nullptr || !numbers(*value, Place(place_, name), "three numbers", parts)) return;
    into = {parts[0], parts[1], parts[2]};
}

void Fields::vector(std::string_view name, std::optional<Vec3>& into) {
    if (is_null(name)) return into.reset();
    if (find(name) == nullptr) return;
    Vec3 read;
    vector(name, read);
    into = read;
}

void Fields::rotation(std::string_view name, Quat& into) {
    std::array<double, 4> parts{};
    const json* value = find(name);
    if (value == nullptr || !numbers(*value, Place(place_, name), "four numbers", parts)) return;
    into = {parts[0], parts[1], parts[2], parts[3]};
}

void Fields::vectors(std::string_view name, std::size_t most, std::vector<Vec3>& into) {
    items(name, most, [&](const json& item, const Place& place) {
        std::array<double, 3> parts{};
        if (numbers(item, place, "three numbers", parts)) into.push_back({parts[0], parts[1], parts[2]});
    });
}

void Fields::rotations(std::string_view name, std::size_t most, std::vector<Quat>& into) {
    if (is_null(name)) return;
    items(name, most, [&](const json& item, const Place& place) {
        std::array<double, 4> parts{};
        if (numbers(item, place, "four numbers", parts)) into.push_back({parts[0], parts[1], parts[2], parts[3]});
    });
}

bool Fields::has_triples(std::string_view name) {
    const json* value = find(name);
    if (value == nullptr || !value->is_array() || value->size() % 3 == 0) return true;  // for items() to refuse
    problems_.add({ProblemCode::kWrongType,
                   Place(place_, name).pointer(),
                   static_cast<double>(value->size()),
                   "a list whose length is a multiple of 3",
                   {},
                   {}});
    return false;
}

void Fields::numbers(std::string_view name, std::size_t most, Range range, std::vector<double>& into) {
    items(name, most, [&](const json& item, const Place& place) {
        const std::optional<double> number = as_number(item);
        if (!number) return problems_.add({ProblemCode::kWrongType, place.pointer(), echo(item), "a number", {}, {}});
        if (const Check wrong = check_range(*number, range, ""))
            return problems_.add(to_field_problem(*wrong, place.pointer()));
        into.push_back(*number);
    });
}

void Fields::flat_vectors(std::string_view name, std::size_t most, std::vector<Vec3>& into) {
    if (!has_triples(name)) return;
    std::vector<double> numbers;
    items(name, 3 * most, [&](const json& item, const Place& place) {
        const std::optional<double> number = as_number(item);
        if (!number) return problems_.add({ProblemCode::kWrongType, place.pointer(), echo(item), "a number", {}, {}});
        numbers.push_back(*number);
    });
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
        into.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
}

void Fields::flat_triples(std::string_view name, std::size_t most, Range range,
                          std::vector<std::array<std::uint32_t, 3>>& into) {
    if (!has_triples(name)) return;
    std::vector<std::uint32_t> numbers;
    items(name, 3 * most, [&](const json& item, const Place& place) {
        if (const auto number = as_whole_number(item, place, range, problems_))
            numbers.push_back(static_cast<std::uint32_t>(*number));
    });
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
        into.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
}

void Fields::require(std::string_view name) {
    if (value_.is_object() && find(name) == nullptr)
        problems_.add({ProblemCode::kMissingField, Place(place_, name).pointer(), {}, "", {}, {}});
}

void Fields::done() {
    if (!value_.is_object()) return;
    for (const auto& [key, value] : value_.items()) {
        if (known_.contains(key)) continue;
        std::string names;
        for (const std::string_view name : known_) names += (names.empty() ? "" : ", ") + std::string(name);
        problems_.add({ProblemCode::kUnknownField,
                       Place(place_, std::string_view(key).substr(0, kLongestEcho)).pointer(),
                       {},
                       names,
                       {},
                       {}});
    }
}

}  // namespace tuftwave::server
