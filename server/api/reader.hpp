#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "api/json_value.hpp"
#include "api/place.hpp"
#include "api/problem.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/schedule.hpp"

namespace tuftwave::server {

/// Seeds: whole numbers up to 2^53 - 1, which every JSON reader keeps.
inline constexpr Range kSeedRange{0, 9007199254740991};

template <class Enum, std::size_t count>
using Choices = std::array<std::pair<std::string_view, Enum>, count>;

/// Reads an object's fields with checked types. A field that is absent leaves its default alone; call done() at the end
/// to find fields that nobody asked for. Client JSON is only looked at, never copied or printed.
class Fields {
  public:
    Fields(JsonValue value, const Place& place, FieldProblems& problems);

    void number(std::string_view name, double& into);
    void number(std::string_view name, std::optional<double>& into);  // null empties it
    void numbers(std::string_view name, std::size_t most, Range range, std::vector<double>& into);
    void integer(std::string_view name, Range range, int& into);
    void integer(std::string_view name, Range range, std::optional<int>& into);
    void seed(std::string_view name, std::uint64_t& into);
    void boolean(std::string_view name, bool& into);
    void boolean(std::string_view name, std::optional<bool>& into);
    void text(std::string_view name, std::size_t longest, std::string& into);
    void text(std::string_view name, std::size_t longest, std::optional<std::string>& into);
    void color(std::string_view name, std::string& into);
    void frame_rate(std::string_view name, FrameRate& into);
    void vector(std::string_view name, Vec3& into);
    void vector(std::string_view name, std::optional<Vec3>& into);
    void rotation(std::string_view name, Quat& into);
    void vectors(std::string_view name, std::size_t most, std::vector<Vec3>& into);
    void rotations(std::string_view name, std::size_t most, std::vector<Quat>& into);
    void flat_vectors(std::string_view name, std::size_t most, std::vector<Vec3>& into);  // x, y, z, x, y, z, ...
    void flat_triples(std::string_view name, std::size_t most, Range range,
                      std::vector<std::array<std::uint32_t, 3>>& into);

    template <class Enum, std::size_t count>
    void choice(std::string_view name, const Choices<Enum, count>& choices, Enum& into) {
        if (const auto value = find(name)) read(name, *value, choices, into);
    }
    template <class Enum, std::size_t count>
    void choice(std::string_view name, const Choices<Enum, count>& choices, std::optional<Enum>& into) {
        if (const auto value = find_or_empty(name, into)) read(name, *value, choices, into.emplace());
    }

    /// Calls read(value, place) with a member that is there; null is for read to refuse.
    template <class Read>
    void member(std::string_view name, Read read) {
        if (const auto value = find(name)) read(*value, Place(place_, name));
    }

    /// The same, but null is as good as absent.
    template <class Read>
    void optional_member(std::string_view name, Read read) {
        if (const auto value = find(name); value && !value->is_null()) read(*value, Place(place_, name));
    }

    /// Calls read(item, place) for each item of an array that has at most `most`; a longer one is refused unread.
    template <class Read>
    void items(std::string_view name, std::size_t most, Read read) {
        if (const auto value = find_array(name, most)) read_items(*value, Place(place_, name), read);
    }

    /// The same, and each item is read into an element of its own: read(item, place, element).
    template <class Element, class Read>
    void elements(std::string_view name, std::size_t most, std::vector<Element>& into, Read read) {
        items_into(name, most, 1, into,
                   [&](const JsonValue item, const Place& place) { read(item, place, into.emplace_back()); });
    }

    void require(std::string_view name);
    void done();

  private:
    std::optional<JsonValue> find(std::string_view name);
    std::optional<JsonValue> find_array(std::string_view name, std::size_t most);

    /// A member that is there; null is as good as absent, and empties `into`.
    template <class Value>
    std::optional<JsonValue> find_or_empty(std::string_view name, std::optional<Value>& into) {
        const auto value = find(name);
        if (!value || !value->is_null()) return value;
        into.reset();
        return {};
    }

    void read(std::string_view name, JsonValue value, double& into);
    void read(std::string_view name, JsonValue value, bool& into);
    void read(std::string_view name, JsonValue value, std::size_t longest, std::string& into);
    void read(std::string_view name, JsonValue value, Vec3& into);
    template <class Enum, std::size_t count>
    void read(std::string_view name, JsonValue value, const Choices<Enum, count>& choices, Enum& into) {
        const auto text = value.text();
        for (const auto& [word, meaning] : choices) {
            if (text != word) continue;
            into = meaning;
            return;
        }
        std::string words;
        for (const auto& [word, meaning] : choices) words += (words.empty() ? "" : ", ") + std::string(word);
        refuse_choice(name, value, words);
    }
    std::optional<double> whole_number(std::string_view name, JsonValue value, Range range);
    bool has_triples(std::string_view name);
    void refuse_type(std::string_view name, JsonValue value, const std::string& wanted);
    void refuse_choice(std::string_view name, JsonValue value, const std::string& words);
    void refuse_numbers(JsonValue value, const Place& place, std::size_t width, const char* wanted);

    /// Like items(), with room for an element of every `width` items.
    template <class Element, class Read>
    void items_into(std::string_view name, std::size_t most, std::size_t width, std::vector<Element>& into, Read read) {
        const auto value = find_array(name, most);
        if (!value) return;
        into.reserve(into.size() + value->size() / width);
        read_items(*value, Place(place_, name), read);
    }

    template <class Read>
    static void read_items(const JsonValue list, const Place& place, Read read) {
        std::size_t i = 0;
        for (const JsonValue item : list.items()) read(item, Place(place, i++));
    }

    const JsonValue value_;
    const Place& place_;
    FieldProblems& problems_;
    std::uint64_t marks_ = 0;              // of the names that are there
    std::vector<std::string_view> known_;  // some twice
};

}  // namespace tuftwave::server
