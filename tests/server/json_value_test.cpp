#include "api/json_value.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

#include "support.hpp"

namespace tuftwave::server {
namespace {

TEST(JsonValue, IsOfOneKind) {
    const JsonDocument document = parsed(R"([null, true, 1, "a", [1], {"a": 1}])");
    std::string kinds;
    for (const JsonValue item : document.root().items()) {
        kinds += item.is_null() ? 'n' : item.is_array() ? 'a' : item.is_object() ? 'o' : '-';
        kinds += item.number() ? '1' : item.boolean() ? 't' : item.text() ? 's' : item.is_nested() ? 'm' : '-';
    }
    EXPECT_EQ(kinds,
              "n--t-1-sam"
              "om");
}

TEST(JsonValue, NumbersAreTheNearestDoubles) {
    for (const auto& [text, number] : {std::pair("0", 0.0), std::pair("-7", -7.0), std::pair("1e-999", 0.0),
                                       std::pair("0.1", 0.1), std::pair("-9223372036854775808", -9223372036854775808.0),
                                       std::pair("18446744073709551615", 18446744073709551615.0),
                                       std::pair("2.2250738585072011e-308", 2.2250738585072011e-308),
                                       std::pair("1.7976931348623157e308", std::numeric_limits<double>::max())}) {
        EXPECT_EQ(parsed(text).root().number(), number) << text;
    }
}

TEST(JsonValue, TextMayHoldAnything) {
    EXPECT_EQ(parsed(R"("a\u0000\u9aea\ud83d\ude00\n")").root().text(), std::string_view("a\0髪😀\n", 10));
    EXPECT_EQ(parsed("\"\"").root().text(), "");
}

TEST(JsonValue, HasMembersByName) {
    const JsonDocument document = parsed(R"({"b": 1, "a": 2})");
    const JsonValue value = document.root();
    EXPECT_EQ(value.size(), 2U);
    EXPECT_EQ(value.find("a")->number(), 2);
    EXPECT_FALSE(value.find("c"));
    EXPECT_FALSE(value.find("a")->find("a"));
    EXPECT_EQ(value.find("a")->size(), 0U);
}

TEST(JsonValue, ReadsSoManyNumbers) {
    std::array<double, 3> numbers{};
    EXPECT_TRUE(parsed("[1, -2.5, 3]").root().read_numbers(numbers));
    EXPECT_EQ(numbers, (std::array<double, 3>{1, -2.5, 3}));
    for (const char* const text : {"[1, 2]", "[1, 2, 3, 4]", "[1, 2, null]", "[[1, 2, 3]]", "1", "{}", "[]"})
        EXPECT_FALSE(parsed(text).root().read_numbers(numbers)) << text;
}

TEST(JsonDocument, IsOfNothingButJson) {
    for (const char* const text : {"",
                                   " ",
                                   "{",
                                   "[1,]",
                                   "01",
                                   "1.",
                                   "1e999",
                                   "[1]x",
                                   "{}{}",
                                   "\"\xff\"",
                                   "\"\xed\xa0\x80\"",
                                   "\"\t\"",
                                   "nul",
                                   "\"\\ud800\"",
                                   "\"\\udc00\"",
                                   "\"\\ud800\\u0041\"",
                                   "\"\\u00g0\"",
                                   "\"\\x\"",
                                   "{\"a\"}",
                                   "{1:2}",
                                   "[1 2]"})
        EXPECT_FALSE(JsonDocument::parse(text)) << text;
    EXPECT_FALSE(JsonDocument::parse(std::string_view("[1]\0", 4)));
}

TEST(JsonDocument, IsNotOfWhatGoesBeyondItsNumbers) {
    for (const char* const text : {"18446744073709551616", "-9223372036854775809", "\xef\xbb\xbf{}"})
        EXPECT_FALSE(JsonDocument::parse(text)) << text;
}

}  // namespace
}  // namespace tuftwave::server
