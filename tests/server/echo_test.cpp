#include "api/echo.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support.hpp"

namespace tuftwave::server {
namespace {

std::variant<std::monostate, double, std::string> echo_of(const std::string& text) {
    const JsonDocument document = parsed(text);
    return echo(document.root());
}

TEST(Echo, OfAScalarIsTheScalar) {
    EXPECT_EQ(std::get<double>(echo_of("0.5")), 0.5);
    EXPECT_EQ(std::get<double>(echo_of("7")), 7);
    EXPECT_EQ(std::get<double>(echo_of("-7")), -7);
    EXPECT_EQ(std::get<double>(echo_of("18446744073709551615")), 18446744073709551615.0);
    EXPECT_EQ(std::get<std::string>(echo_of("true")), "true");
}

TEST(Echo, OfALongTextIsItsBeginning) {
    EXPECT_EQ(std::get<std::string>(echo_of('"' + std::string(1000, 'x') + '"')), std::string(kLongestEcho, 'x'));
}

TEST(Echo, OfAnythingLargerSaysWhatItIs) {
    EXPECT_EQ(std::get<std::string>(echo_of("[1,2]")), "array");
    EXPECT_EQ(std::get<std::string>(echo_of("{}")), "object");
    EXPECT_EQ(std::get<std::string>(echo_of("null")), "null");
}

}  // namespace
}  // namespace tuftwave::server
