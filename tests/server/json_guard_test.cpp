#include "api/json_guard.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support.hpp"

namespace tuftwave::server {
namespace {

std::string outcome(const std::string& body, const JsonLimits& limits = {}) {
    const auto parsed = parse_guarded(body, limits);
    const auto* problem = std::get_if<Problem>(&parsed);
    return problem == nullptr ? "parsed" : slug(problem->code);
}

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST(JsonGuard, AcceptsWhatIsJson) {
    for (const char* const body :
         {"{}", "[]", "1", "\"\\\"{[\"", R"({"a":{"a":[1,"}",{"a":null}]},"b":"\\"})", " [1 , 2 ] \n"}) {
        EXPECT_EQ(outcome(body), "parsed") << body;
    }
}

TEST(JsonGuard, RefusesWhatIsNotJson) {
    for (const char* const body : {"", "{", "[1,]", "{\"a\"}", "NaN", "[Infinity]", "\"open", "{\"a\":1}}", "[1]x",
                                   "'a'", "\"\xff\"", "[1e999]", "\"\\"}) {
        EXPECT_EQ(outcome(body), "malformed") << body;
    }
}

TEST(JsonGuard, ReadsWhatOnlyTheExactParserDoes) {
    for (const char* const body : {"18446744073709551616", "[-9223372036854775809,1e2]", "\xef\xbb\xbf{\"a\":[1]}",
                                   R"({"a":"\u9aea\ud83d\ude00\"","b":[1e-320]})", "1e-400", "[0.1,-0.0]"}) {
        const auto read = parse_guarded(body, {});
        ASSERT_TRUE(std::holds_alternative<JsonDocument>(read)) << body;
        EXPECT_EQ(as_plain(std::get<JsonDocument>(read).root()), nlohmann::json::parse(body)) << body;
    }
}

TEST(JsonGuard, SaysWhatComesFirstInTheBody) {
    const auto detail = [](const char* body) { return std::get<Problem>(parse_guarded(body, {})).detail; };
    EXPECT_EQ(detail(R"({"a":1,"a":[1,]})"), "The key \"a\" occurs twice in one object at byte 9.");
    EXPECT_EQ(detail(R"({"a":[1,],"a":1})"),
              "The key \"a\" occurs twice in one object at byte 12.");  // before the grammar
    EXPECT_EQ(detail(R"({"a":[1,]})"), "The JSON is not valid at byte 9.");
    EXPECT_EQ(detail("[1e999]"), "A number is too large to be represented.");
}

TEST(JsonGuard, SurvivesTextAfterTheEnd) {
    for (const char* const body : {R"({}"")", R"({]")", R"({}"a")", R"([]{"a)"})
        EXPECT_EQ(outcome(body), "malformed") << body;
    EXPECT_EQ(outcome(std::string("{}\0{\"a\":1,\"a\":2}", 16)), "malformed");  // the parser alone stops at the NUL
}

TEST(JsonGuard, NestsThirtyTwoDeepAndNoDeeper) {
    EXPECT_EQ(outcome(nested(32)), "parsed");
    EXPECT_EQ(outcome(nested(33)), "too_deep");
    EXPECT_EQ(outcome(std::string(1'000'000, '[')), "too_deep");          // a copy of this would overflow the stack
    EXPECT_EQ(outcome("[\"" + std::string(100, '[') + "\"]"), "parsed");  // brackets in text are no nesting
}

TEST(JsonGuard, ReadsEscapedKeysWhereTheyAreAllowed) {
    JsonLimits limits;
    EXPECT_EQ(outcome(R"({"\u9aea":1})", limits), "malformed");
    limits.has_escaped_keys = true;
    EXPECT_EQ(outcome(R"({"\u9aea":1,"a\"b":2})", limits), "parsed");
    EXPECT_EQ(outcome(R"({"\u0061":1,"a":2})", limits), "duplicate_key");
    EXPECT_EQ(outcome(R"({"\ud800":1})", limits), "malformed");
}

TEST(JsonGuard, FindsDuplicateKeysInTheSameObjectOnly) {
    EXPECT_EQ(outcome(R"({"a":1,"a":2})"), "duplicate_key");
    EXPECT_EQ(outcome(R"({"b":[{"a":1},{"a":2}],"a":{"a":3}})"), "parsed");
    EXPECT_EQ(outcome(R"({"x":{"c":0},"y":[{"a":1,"b":"a","a":2}]})"), "duplicate_key");
    EXPECT_EQ(outcome(R"({"a":1,"\u0061":2})"), "malformed");  // the same key in disguise
    EXPECT_EQ(outcome(R"({"a":"b","b":"a"})"), "parsed");      // values are no keys
}

TEST(JsonGuard, CountsValuesBytesAndKeys) {
    EXPECT_EQ(outcome("[1,2,3]", {100, 32, 4, 64}), "parsed");
    EXPECT_EQ(outcome("[1,2,3,4]", {100, 32, 4, 64}), "too_many_values");
    EXPECT_EQ(outcome("[1,2,3]", {7, 32, 100, 64}), "parsed");
    EXPECT_EQ(outcome("[1,2,3]", {6, 32, 100, 64}), "too_large");
    EXPECT_EQ(outcome(R"({"a":1,"b":2})", {100, 32, 100, 2}), "parsed");
    EXPECT_EQ(outcome(R"({"a":1,"b":2,"c":3})", {100, 32, 100, 2}), "too_many_values");
}

std::string repeated(const std::string& item, std::size_t count) {
    std::string list = "[" + item;
    for (std::size_t i = 1; i < count; ++i) list += "," + item;
    return list + "]";
}

TEST(JsonGuard, WeighsValuesByWhatTheyCost) {
    JsonLimits limits;
    limits.memory = 80 * 1'000 + 96;  // a list of a thousand
    EXPECT_EQ(outcome(repeated("0", 2'000), limits), "parsed");
    EXPECT_EQ(outcome(repeated("[]", 800), limits), "parsed");
    for (const char* const item : {"[]", "{}", "[0]", "{\"\":0}", "{\"a\":[]}", "\"0123456789abcdef0123456789abcdef\""})
        EXPECT_EQ(outcome(repeated(item, 1'001), limits), "too_many_values") << item;
    EXPECT_EQ(outcome(repeated("\"0123456789abcde\"", 1'001), limits), "parsed");
    EXPECT_EQ(outcome("{\"" + std::string(80'000, 'a') + "\":0}", limits), "too_many_values");
}

TEST(JsonGuard, ParsesTheLargestHairstyle) {
    const std::string tuft = R"({"name":"tuft_12345678901","points":)" + repeated("[0.123456,0.123456,-0.123456]", 8) +
                             R"(,"diameter":20.5,"widest_at":50,"taper":"tapered","section":"ellipse","flatness":0.5,)"
                             R"("twist_deg":1.5,"roll_deg":1.5,"joints":4,"phase":0.5,"cycles":1})";
    const std::string body = R"({"head":{"scalp":{"mesh":{"positions":)" + repeated("0.1234", 600'000) +
                             R"(,"triangles":)" + repeated("9999", 600'000) + R"(}}},"tufts":)" +
                             repeated(tuft, 16'384) + "}";
    EXPECT_LT(body.size(), JsonLimits{}.bytes);
    EXPECT_EQ(outcome(body), "parsed");
}

}  // namespace
}  // namespace tuftwave::server
