#include "api/json_guard.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

namespace tuftwave::server {
namespace {

Problem refusal(ProblemCode code, std::string detail) { return {code, std::move(detail), {}, {}}; }

std::string at_byte(std::size_t at) { return " at byte " + std::to_string(at + 1); }

// What the parser's document costs, in bytes as glibc hands them out: 8 MiB of "[]," would become 268 MiB.
constexpr std::size_t kValueCost = 16;                   // of any value, where it stands
constexpr std::size_t kListCost = 64, kObjectCost = 64;  // their heads, and room that lists keep in reserve
constexpr std::size_t kTextCost = 48, kKeyCost = 80;
constexpr std::size_t kShortText = 15, kLongTextCost = 17;  // longer ones need a place of their own

/// One pass over the bytes. It does not check the grammar, which the parser does, only what the parser does not.
class Scan {
  public:
    Scan(std::string_view body, const JsonLimits& limits) : body_(body), limits_(limits) {}

    std::optional<Problem> run() {
        while (at_ < body_.size() && !problem_) step();
        return problem_;
    }

  private:
    void step() {
        const char c = body_[at_];
        if (c == '"') return text();
        if (c == '\0') {  // the parser takes it for the end and would ignore the rest
            problem_ = refusal(ProblemCode::kMalformed, "The JSON is not valid" + at_byte(at_) + ".");
            return;
        }
        if (c == '{' || c == '[') open(c == '{');
        if (c == '{' || c == '[') weigh(c == '{' ? kObjectCost : kListCost);
        if (c == '}' || c == ']') close();
        if (c == ',' || c == '[' || c == '{') count_value();
        if (c == ',' || c == '{') expects_key_ = !open_.empty() && open_.back().is_object;
        ++at_;
    }

    void open(bool is_object) {
        open_.push_back({is_object, {}});
        if (open_.size() > limits_.depth)
            problem_ = refusal(ProblemCode::kTooDeep, "Nested more than " + std::to_string(limits_.depth) +
                                                          " levels deep" + at_byte(at_) + ".");
    }

    void close() {
        if (!open_.empty()) open_.pop_back();
        expects_key_ = false;  // what follows {} is no key, although nothing came between
    }

    void weigh(std::size_t cost) {
        memory_ += cost;
        if (memory_ > limits_.memory && !problem_)
            problem_ =
                refusal(ProblemCode::kTooManyValues, "More values than fit into " + std::to_string(limits_.memory) +
                                                         " bytes of memory" + at_byte(at_) + ".");
    }

    void weigh_text(std::size_t cost, std::size_t bytes) {
        weigh(cost + (bytes > kShortText ? bytes + kLongTextCost : 0));
    }

    void count_value() {
        weigh(kValueCost);
        if (++values_ > limits_.values)
            problem_ = refusal(ProblemCode::kTooManyValues,
                               "More than " + std::to_string(limits_.values) + " values" + at_byte(at_) + ".");
    }

    void text() {
        const std::size_t start = ++at_;
        bool is_escaped = false;
        while (at_ < body_.size() && body_[at_] != '"') {
            if (body_[at_] == '\\') {
                is_escaped = true;
                ++at_;
            }
            ++at_;
        }
        if (at_ >= body_.size()) {
            problem_ = refusal(ProblemCode::kMalformed, "A string does not end.");
            return;
        }
        weigh_text(expects_key_ ? kKeyCost : kTextCost, at_ - start);
        if (problem_) return;
        if (expects_key_) key(body_.substr(start, at_ - start), is_escaped, start);
        expects_key_ = false;
        ++at_;
    }

    void key(std::string_view name, bool is_escaped, std::size_t start) {
        std::vector<std::string_view>& keys = open_.back().keys;
        if (is_escaped && limits_.has_escaped_keys) {
            weigh_text(kTextCost, name.size());
            name = unescaped(name);
            is_escaped = false;
        }
        if (is_escaped) {  // an escaped key could hide a second one
            problem_ = refusal(ProblemCode::kMalformed, "A key contains a backslash" + at_byte(start) + ".");
        } else if (std::find(keys.begin(), keys.end(), name) != keys.end()) {
            problem_ = refusal(ProblemCode::kDuplicateKey, "The key \"" + std::string(name.substr(0, 64)) +
                                                               "\" occurs twice in one object" + at_byte(start) + ".");
        } else if (keys.size() == limits_.keys_per_object) {
            problem_ = refusal(ProblemCode::kTooManyValues, "More than " + std::to_string(limits_.keys_per_object) +
                                                                " keys in one object" + at_byte(start) + ".");
        }
        keys.push_back(name);
    }

    /// What an escaped key says; of a broken one, which the parser refuses, nothing.
    std::string_view unescaped(std::string_view name) {
        const nlohmann::json read = nlohmann::json::parse('"' + std::string(name) + '"', nullptr, false);
        return read.is_string() ? unescaped_.emplace_back(read.get<std::string>()) : std::string_view{};
    }

    struct Open {
        bool is_object;
        std::vector<std::string_view> keys;
    };

    std::string_view body_;
    const JsonLimits& limits_;
    std::size_t at_ = 0, values_ = 1, memory_ = 0;
    bool expects_key_ = false;
    std::vector<Open> open_;
    std::deque<std::string> unescaped_;  // what keys point to
    std::optional<Problem> problem_;
};

std::optional<Problem> check_size(std::string_view body, const JsonLimits& limits) {
    if (body.size() <= limits.bytes) return {};
    return refusal(ProblemCode::kTooLarge, "The JSON has " + std::to_string(body.size()) + " bytes; at most " +
                                               std::to_string(limits.bytes) + " are allowed.");
}

template <class Json>
std::variant<Json, Problem> parse_exactly(std::string_view body) {
    try {
        return Json::parse(body);
    } catch (const nlohmann::json::parse_error& error) {
        return refusal(ProblemCode::kMalformed,
                       "The JSON is not valid" + at_byte(error.byte == 0 ? 0 : error.byte - 1) + ".");
    } catch (const nlohmann::json::out_of_range&) {
        return refusal(ProblemCode::kMalformed, "A number is too large to be represented.");
    }
}

/// How often any of `marks` occurs, within text as well.
template <std::size_t count>
std::array<std::size_t, count> count_marks(std::string_view body, const std::array<char, count>& marks) {
    constexpr std::size_t kBlock = 255;  // bytes; what fits into a counter of one byte, of which vectors hold the most
    std::array<std::size_t, count> found{};
    for (; !body.empty(); body.remove_prefix(std::min(kBlock, body.size()))) {
        for (std::size_t i = 0; i < count; ++i) {
            std::uint8_t in_block = 0;
            for (const char c : body.substr(0, kBlock))
                in_block = static_cast<std::uint8_t>(in_block + (c == marks[i]));
            found[i] += in_block;
        }
    }
    return found;
}

/// Whether the scan would find neither an escaped key nor too many values, by what can be told fast.
bool is_moderate(std::string_view body, const JsonLimits& limits) {
    constexpr std::size_t kMostPerByte = kValueCost + std::max(kListCost, kObjectCost) + 1;
    if (body.find('\\') != std::string_view::npos) return false;
    if (body.size() < limits.values && body.size() * kMostPerByte <= limits.memory) return true;
    const auto [commas, lists, objects, quotes] = count_marks<4>(body, {',', '[', '{', '"'});
    const std::size_t values = 1 + commas + lists + objects;
    const std::size_t memory = values * kValueCost + lists * kListCost + objects * kObjectCost +
                               (1 + quotes / 2) * (kKeyCost + kLongTextCost) + body.size();
    return values <= limits.values && memory <= limits.memory;
}

bool is_repeated(const simdjson::dom::object members, const simdjson::dom::object::iterator& member) {
    for (auto before = members.begin(); before != member; ++before) {
        if (before.key() == member.key()) return true;
    }
    return false;
}

/// Whether the scan would find nothing about nesting and keys. @param levels  how many there may be
bool is_sound(const JsonValue value, const std::size_t levels, const JsonLimits& limits) {
    const auto is_sound_within = [&](const JsonValue inner) {
        return !inner.is_nested() || is_sound(inner, levels - 1, limits);
    };
    if (value.is_nested() && levels == 0) return false;
    if (value.is_array()) {
        for (const JsonValue item : value.items()) {
            if (!is_sound_within(item)) return false;
        }
    }
    if (value.is_object()) {
        const simdjson::dom::object members = value.members();
        if (members.size() > limits.keys_per_object) return false;
        for (auto member = members.begin(); member != members.end(); ++member) {
            if (is_repeated(members, member) || !is_sound_within(member.value())) return false;
        }
    }
    return true;
}

/// The document of what is as nearly all requests are; nothing where only the scan can tell.
std::optional<JsonDocument> parse_usual(std::string_view body, const JsonLimits& limits) {
    if (!is_moderate(body, limits)) return {};
    std::optional<JsonDocument> document = JsonDocument::parse(body);
    if (document && !is_sound(document->root(), limits.depth, limits)) document.reset();
    return document;
}

}  // namespace

std::variant<JsonDocument, Problem> parse_guarded(std::string_view body, const JsonLimits& limits) {
    if (auto problem = check_size(body, limits)) return *std::move(problem);
    if (auto usual = parse_usual(body, limits)) return *std::move(usual);
    if (auto problem = Scan(body, limits).run()) return *std::move(problem);
    if (auto document = JsonDocument::parse(body)) return *std::move(document);
    auto exact = parse_exactly<nlohmann::json>(body);
    if (auto* problem = std::get_if<Problem>(&exact)) return std::move(*problem);
    // It has a number that only doubles can hold, or a byte order mark: written anew it has not.
    const std::string anew = std::get<nlohmann::json>(exact).dump();
    exact = Problem{};  // may be the largest part of all
    return JsonDocument::parse(anew).value();
}

std::variant<nlohmann::ordered_json, Problem> parse_guarded_in_order(std::string_view body, const JsonLimits& limits) {
    if (auto problem = check_size(body, limits)) return *std::move(problem);
    if (auto problem = Scan(body, limits).run()) return *std::move(problem);
    return parse_exactly<nlohmann::ordered_json>(body);
}

}  // namespace tuftwave::server
