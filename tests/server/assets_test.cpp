#include "assets/assets.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace tuftwave::server {
namespace {

TEST(Assets, ContractIsTheFileByteForByte) {
    std::ifstream file(TUFTWAVE_TEST_DATA "/../../api/openapi.yaml", std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    ASSERT_FALSE(text.empty());
    EXPECT_EQ(asset("openapi.yaml"), text);
}

TEST(Assets, UnknownNameIsNothing) {
    for (const char* name : {"", "openapi", "../openapi.yaml", "api/openapi.yaml"}) EXPECT_FALSE(asset(name)) << name;
}

}  // namespace
}  // namespace tuftwave::server
