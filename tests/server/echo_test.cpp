#include "api/echo.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace tuftwave::server {
namespace {

TEST(Echo, OfAScalarIsTheScalar) {
    EXPECT_EQ(std::get<double>(echo(0.5)), 0.5);
    EXPECT_EQ(std::get<double>(echo(7)), 7);
    EXPECT_EQ(std::get<double>(echo(-7)), -7);
    EXPECT_EQ(std::get<std::string>(echo(true)), "true");
}

TEST(Echo, OfALongTextIsItsBeginning) {
    EXPECT_EQ(std::get<std::string>(echo(std::string(1000, 'x'))), std::string(kLongestEcho, 'x'));
}

TEST(Echo, OfAnythingLargerSaysWhatItIs) {
    EXPECT_EQ(std::get<std::string>(echo(nlohmann::json::array({1, 2}))), "array");
    EXPECT_EQ(std::get<std::string>(echo(nlohmann::json::object())), "object");
    EXPECT_EQ(std::get<std::string>(echo(nullptr)), "null");
}

TEST(AsNumber, TakesNumbersOnly) {
    EXPECT_EQ(as_number(3), 3.0);
    EXPECT_EQ(as_number(-0.25), -0.25);
    EXPECT_FALSE(as_number("3"));
    EXPECT_FALSE(as_number(true));
}

}  // namespace
}  // namespace tuftwave::server
