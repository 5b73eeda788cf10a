#include "gltf/json_text.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

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

template <class Number>
void write_whole(JsonText& to, Number value) {
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    to.raw({digits, static_cast<std::size_t>(end - digits)});
}

}  // namespace

JsonText& JsonText::text(const std::string& value) {
    if (!std::all_of(value.begin(), value.end(), is_plain)) return raw(Json(value).dump());
    return raw("\"").raw(value).raw("\"");
}

JsonText& JsonText::number(double value) {
    char digits[64];
    const char* const end = nlohmann::detail::to_chars(digits, digits + sizeof digits, value);
    return raw({digits, static_cast<std::size_t>(end - digits)});
}

JsonText& JsonText::number(std::size_t value) {
    write_whole(*this, value);
    return *this;
}

JsonText& JsonText::number(int value) {
    write_whole(*this, value);
    return *this;
}

std::string extras_text(const Json& extras) {
    std::string out;
    write_value(extras, out);
    return out;
}

}  // namespace tuftwave::server::gltf
