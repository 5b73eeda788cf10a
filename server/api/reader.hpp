#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
    Fields(const nlohmann::json& value, const Place& place, FieldProblems& problems);

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
        const nlohmann::json* value = find(name);
        if (value == nullptr) return;
        if (const auto* text = value->get_ptr<const std::string*>()) {
            for (const auto& [word, meaning] : choices) {
                if (word == *text) {
                    into = meaning;
                    return;
                }
            }
        }
        std::string words;
        for (const auto& [word, meaning] : choices) words += (words.empty() ? "" : ", ") + std::string(word);
        refuse_choice(name, *value, words);
    }
    template <class Enum, std::size_t count>
    void choice(std::string_view name, const Choices<Enum, count>& choices, std::optional<Enum>& into) {
        if (is_null(name)) return into.reset();
        if (find(name) == nullptr) return;
        Enum chosen{};
        choice(name, choices, chosen);
        into = chosen;
    }

    /// Calls read(value, place) with a member that is there; null is for read to refuse.
    template <class Read>
    void member(std::string_view name, Read read) {
        if (const nlohmann::json* value = find(name)) read(*value, Place(place_, name));
    }

    /// The same, but null is as good as absent.
    template <class Read>
    void optional_member(std::string_view name, Read read) {
        if (!is_null(name)) member(name, read);
    }

    /// Calls read(item, place) for each item of an array that has at most `most`; a longer one is refused unread.
    template <class Read>
    void items(std::string_view name, std::size_t most, Read read) {
        const nlohmann::json* value = find(name);
        if (value == nullptr) return;
        if (!value->is_array()) return refuse_type(name, *value, "an array");
        const Place list(place_, name);
        if (const Check wrong = check_count(value->size(), 0, most, ""))
            return problems_.add(to_field_problem(*wrong, list.pointer()));
        for (std::size_t i = 0; i < value->size(); ++i) read((*value)[i], Place(list, i));
    }

    void require(std::string_view name);
    void done();

  private:
    const nlohmann::json* find(std::string_view name);
    bool is_null(std::string_view name);
    std::optional<double> whole_number(std::string_view name, Range range);
    bool has_triples(std::string_view name);
    void refuse_type(std::string_view name, const nlohmann::json& value, const std::string& wanted);
    void refuse_choice(std::string_view name, const nlohmann::json& value, const std::string& words);
    template <std::size_t width>
    bool numbers(const nlohmann::json& value, const Place& place, const char* wanted, std::array<double, width>& into);

    const nlohmann::json& value_;
    const Place& place_;
    FieldProblems& problems_;
    std::set<std::string_view> known_;
};

}  // namespace tuftwave::server
