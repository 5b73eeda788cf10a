#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "api/json_guard.hpp"
#include "targets.hpp"

namespace tuftwave::server::fuzz {
namespace {

using nlohmann::json;

/// What the library's own parser says of a text, counted without a document.
struct Counts final : nlohmann::json_sax<json> {
    std::size_t values = 0, depth = 0, deepest = 0, most_keys = 0;
    bool has_duplicates = false;
    std::vector<std::set<std::string>> open;

    bool value() { return ++values > 0; }
    bool begin() {
        open.emplace_back();
        deepest = std::max(deepest, open.size());
        return value();
    }
    bool end() {
        open.pop_back();
        return true;
    }

    bool null() override { return value(); }
    bool boolean(bool) override { return value(); }
    bool number_integer(json::number_integer_t) override { return value(); }
    bool number_unsigned(json::number_unsigned_t) override { return value(); }
    bool number_float(json::number_float_t, const std::string&) override { return value(); }
    bool string(std::string&) override { return value(); }
    bool binary(json::binary_t&) override { return value(); }
    bool start_object(std::size_t) override { return begin(); }
    bool start_array(std::size_t) override { return begin(); }
    bool end_object() override { return end(); }
    bool end_array() override { return end(); }
    bool key(std::string& name) override {
        has_duplicates |= !open.back().insert(name).second;
        most_keys = std::max(most_keys, open.back().size());
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const json::exception&) override { return false; }
};

/// Whether two readers of JSON say the same; whole numbers may have become the nearest doubles.
bool is_same(const JsonValue value, const json& other) {
    if (const auto number = value.number()) return other.is_number() && *number == other.get<double>();
    if (const auto flag = value.boolean()) return other.is_boolean() && *flag == other.get<bool>();
    if (const auto text = value.text()) return other.is_string() && *text == other.get_ref<const std::string&>();
    if (value.is_null()) return other.is_null();
    if (value.is_array() != other.is_array() || value.size() != other.size()) return false;
    std::size_t i = 0;
    if (value.is_array()) {
        for (const JsonValue item : value.items()) {
            if (!is_same(item, other[i++])) return false;
        }
        return true;
    }
    for (const auto& [key, member] : value.members()) {
        if (!other.contains(key) || !is_same(member, other[std::string(key)])) return false;
    }
    return true;
}

void require_agreement(const std::string_view text, const JsonLimits& limits) {
    Counts counts;
    const bool is_json = json::sax_parse(text, &counts) && text.find('\0') == std::string_view::npos;
    const auto parsed = parse_guarded(text, limits);
    const auto* problem = std::get_if<Problem>(&parsed);
    if (problem == nullptr) {
        require(is_json, "what is accepted is JSON");
        require(is_same(std::get<JsonDocument>(parsed).root(), json::parse(text)), "what is accepted is what was sent");
        require(counts.deepest <= limits.depth, "it is no deeper than allowed");
        require(counts.values <= limits.values, "it has no more values than allowed");
        require(counts.most_keys <= limits.keys_per_object, "no object has more keys than allowed");
        require(!counts.has_duplicates, "no key comes twice");
        return;
    }
    const int code = status(problem->code);
    require(code == 400 || code == 413, "what is refused is malformed or too large");
    if (!is_json) return;
    const bool may_have_escaped_key = !limits.has_escaped_keys && text.find('\\') != std::string_view::npos;
    require(problem->code != ProblemCode::kMalformed || may_have_escaped_key, "what is JSON is not malformed");
    require(problem->code != ProblemCode::kTooDeep || counts.deepest > limits.depth, "what is too deep is deep");
    require(problem->code != ProblemCode::kDuplicateKey || counts.has_duplicates, "what comes twice does");
}

}  // namespace

void run_json(const Target&, const std::string_view input) {
    for (const bool has_escaped_keys : {false, true}) {
        JsonLimits limits;
        limits.depth = 6;
        limits.values = 48;
        limits.keys_per_object = 6;
        limits.has_escaped_keys = has_escaped_keys;
        require_agreement(input, limits);
    }
}

}  // namespace tuftwave::server::fuzz
