#include "character/file_value.hpp"

#include <utility>

#include "character/file_limits.hpp"

namespace tuftwave::server::character {
namespace {

std::string escaped(std::string_view key) {
    std::string token;
    for (const char c : key) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return token;
}

std::variant<std::monostate, double, std::string> shown(const FileJson& json) {
    constexpr std::size_t kLongest = 64;  // bytes
    if (json.is_number()) return json.get<double>();
    if (json.is_string()) return json.get_ref<const std::string&>().substr(0, kLongest);
    return {};
}

}  // namespace

FileValue::FileValue(const FileJson* json, std::string pointer, std::optional<Fault>& fault)
    : json_(json), pointer_(std::move(pointer)), fault_(&fault) {}

FileValue FileValue::child(const FileJson* json, std::string_view key) const {
    return {json, pointer_ + "/" + escaped(key), *fault_};
}

FileValue FileValue::operator[](std::string_view name) const {
    if (exists() && !json_->is_object()) refuse(Fault::Kind::kWrongType, "an object");
    if (!exists() || !json_->is_object()) return child(nullptr, name);
    const auto found = json_->find(std::string(name));
    return child(found == json_->end() ? nullptr : &*found, name);
}

FileValue FileValue::at(std::size_t index) const { return child(&(*json_)[index], std::to_string(index)); }

std::size_t FileValue::size() const {
    if (!exists()) return 0;
    if (json_->is_array()) return json_->size();
    refuse(Fault::Kind::kWrongType, "an array");
    return 0;
}

std::vector<std::string> FileValue::keys() const {
    std::vector<std::string> found;
    if (!exists()) return found;
    if (!json_->is_object()) refuse(Fault::Kind::kWrongType, "an object");
    if (json_->is_object()) {
        for (const auto& [key, value] : json_->items()) found.push_back(key);
    }
    return found;
}

std::string FileValue::text() const {
    if (!exists()) return "";
    if (json_->is_string()) return json_->get<std::string>();
    refuse(Fault::Kind::kWrongType, "text");
    return "";
}

std::string FileValue::name() const {
    std::string name = text();
    if (name.size() <= kFileLimits.name_bytes) return name;
    refuse(Fault::Kind::kOutOfRange, "a name of at most " + std::to_string(kFileLimits.name_bytes) + " bytes");
    return "";
}

bool FileValue::flag() const {
    if (!exists()) return false;
    if (json_->is_boolean()) return json_->get<bool>();
    refuse(Fault::Kind::kWrongType, "true or false");
    return false;
}

std::optional<std::size_t> FileValue::whole(std::size_t most) const {
    if (!exists()) return {};
    if (!json_->is_number()) {
        refuse(Fault::Kind::kWrongType, "a whole number");
        return {};
    }
    const auto number = json_->get<double>();
    const Range range{0, static_cast<double>(most)};
    if (is_within(number, range) && number == static_cast<double>(static_cast<std::size_t>(number)))
        return static_cast<std::size_t>(number);
    refuse_number(number, range);
    return {};
}

std::optional<int> FileValue::index(std::size_t count) const {
    if (!exists()) return {};
    if (count == 0) {
        refuse(Fault::Kind::kOutOfRange, "nothing, since the file has none");
        return {};
    }
    const std::optional<std::size_t> number = whole(count - 1);
    return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

std::vector<int> FileValue::indices(std::size_t count) const {
    std::vector<int> found;
    const std::size_t items = size();
    for (std::size_t i = 0; i < items; ++i) {
        const FileJson& item = (*json_)[i];
        const bool is_sound = item.is_number_unsigned() && item.get<std::size_t>() < count;
        const std::optional<int> number = is_sound ? item.get<int>() : at(i).index(count);
        if (!number) return {};
        found.push_back(*number);
    }
    return found;
}

void FileValue::refuse(Fault::Kind kind, std::string allowed) const {
    if (*fault_) return;
    *fault_ = Fault{kind,
                    pointer_,
                    exists() ? shown(*json_) : std::variant<std::monostate, double, std::string>{},
                    std::move(allowed),
                    {},
                    {}};
}

void FileValue::refuse_number(double given, Range range) const {
    const Check wrong = check_range(given, range, "");
    refuse(Fault::Kind::kOutOfRange, wrong ? wrong->allowed : "a whole number");
    if ((*fault_)->pointer != pointer_) return;
    (*fault_)->minimum = range.minimum;
    (*fault_)->maximum = range.maximum;
}

}  // namespace tuftwave::server::character
