#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "character/fault.hpp"
#include "tuftwave/limits.hpp"

namespace tuftwave::server::character {

/// JSON that keeps its keys in the order in which they came.
using FileJson = nlohmann::ordered_json;

/// One value of an uploaded file's JSON, and where it stands. Whatever is asked of it is checked; the first thing that
/// is wrong goes into `fault`, and reads as if it were absent.
class FileValue {
  public:
    /// @param fault  where the first fault of all values made from this one goes
    FileValue(const FileJson* json, std::string pointer, std::optional<Fault>& fault);

    bool exists() const { return json_ != nullptr; }
    const std::string& pointer() const { return pointer_; }

    FileValue operator[](std::string_view name) const;  ///< a member; absent where this is, wrong if this is no object
    FileValue at(std::size_t index) const;              ///< an item. @param index  below size()
    std::size_t size() const;                           ///< items; 0 if absent, wrong if this is no array
    std::vector<std::string> keys() const;              ///< of an object; none if absent, wrong if this is none

    std::string text() const;                                  ///< "" if absent
    std::string name() const;                                  ///< text that answers may repeat, so not an endless one
    bool flag() const;                                         ///< false if absent
    std::optional<std::size_t> whole(std::size_t most) const;  ///< from 0 to `most`
    std::optional<int> index(std::size_t count) const;         ///< below `count`
    std::vector<int> indices(std::size_t count) const;         ///< each below `count`
    template <std::size_t width>
    std::optional<std::array<double, width>> numbers(Range range) const;

    /// Says that something is wrong with this value.
    void refuse(Fault::Kind kind, std::string allowed) const;

  private:
    void refuse_number(double given, Range range) const;
    FileValue child(const FileJson* json, std::string_view key) const;

    const FileJson* json_;
    std::string pointer_;
    std::optional<Fault>* fault_;
};

template <std::size_t width>
std::optional<std::array<double, width>> FileValue::numbers(Range range) const {
    if (!exists()) return {};
    std::array<double, width> found{};
    const std::string wanted = "an array of " + std::to_string(width) + " numbers";
    if (!json_->is_array() || json_->size() != width) {
        refuse(Fault::Kind::kWrongType, wanted);
        return {};
    }
    for (std::size_t i = 0; i < width; ++i) {
        if (!(*json_)[i].is_number()) {
            at(i).refuse(Fault::Kind::kWrongType, "a number");
            return {};
        }
        found[i] = (*json_)[i].template get<double>();
        if (!is_within(found[i], range)) {
            at(i).refuse_number(found[i], range);
            return {};
        }
    }
    return found;
}

}  // namespace tuftwave::server::character
