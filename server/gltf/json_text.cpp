#include "gltf/json_text.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "gltf/double_text.hpp"

namespace tuftwave::server::gltf {
namespace {

using Json = nlohmann::json;

bool is_plain(char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; }

void write_scalar(const Json& value, std::string& out) {
    const bool is_wide = value.is_number_integer() && !std::in_range<int>(value.get<std::int64_t>());
    out += is_wide ? Json(value.get<double>()).dump() : value.dump();
}

/// Deep at most as our own answers are, never as a client's JSON.
void write_value(const Json& value, std::string& out) {
    if (!value.is_structured()) return write_scalar(value, out);
    bool is_empty = true;
    for (auto item = value.begin(); item != value.end(); ++item) {
        if (item->is_null()) continue;
        out += is_empty ? (value.is_object() ? "{" : "[") : ",";
        if (value.is_object()) out += Json(item.key()).dump() + ":";
        write_value(*item, out);
        is_empty = false;
    }
    out += is_empty ? "null" : value.is_object() ? "}" : "]";
}

}  // namespace

JsonText& JsonText::text(std::string_view value) {
    if (!std::all_of(value.begin(), value.end(), is_plain)) return raw(Json(value).dump());
    return raw("\"").raw(value).raw("\"");
}

template <class Write>
JsonText& JsonText::digits(const Write& write) {
    char counted[kMostDigits];
    char* const at = out_ == nullptr ? counted : out_ + bytes_;
    bytes_ += static_cast<std::size_t>(write(at, at + kMostDigits) - at);
    return *this;
}

JsonText& JsonText::searched(double value) {
    return digits([&](char* from, char*) { return write_double(from, value); });
}

JsonText& JsonText::number(std::size_t value) {
    return digits([&](char* from, char* to) { return std::to_chars(from, to, value).ptr; });
}

JsonText& JsonText::number(int value) {
    return digits([&](char* from, char* to) { return std::to_chars(from, to, value).ptr; });
}

std::string extras_text(const Json& extras) {
    std::string out;
    write_value(extras, out);
    return out;
}

}  // namespace tuftwave::server::gltf
