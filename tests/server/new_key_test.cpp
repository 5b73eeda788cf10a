#include "access/new_key.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <variant>

#include "access/keys.hpp"

namespace tuftwave::server {
namespace {

TEST(NewKey, IsFoundThroughItsLine) {
    const NewKey made = new_key("alice");
    const auto keys = Keys::parse(made.line + "\n");
    ASSERT_TRUE(std::holds_alternative<Keys>(keys)) << made.line;
    EXPECT_EQ(std::get<Keys>(keys).find(made.key), 0u);
    EXPECT_EQ(std::get<Keys>(keys).at(0).name, "alice");
}

TEST(NewKey, Has32BytesInLettersThatNeedNoQuotes) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    const std::string key = new_key("alice").key;
    EXPECT_EQ(key.size(), 3u + 43u);  // 43 letters of 6 bits for 256 bits
    EXPECT_EQ(key.substr(0, 3), "tw_");
    EXPECT_EQ(key.find_first_not_of(letters), std::string::npos) << key;
}

TEST(NewKey, EachIsAnotherAndNoneIsInItsLine) {
    std::set<std::string> keys;
    for (int i = 0; i < 100; ++i) {
        const NewKey made = new_key("alice");
        EXPECT_TRUE(keys.insert(made.key).second);
        EXPECT_EQ(made.line.find(made.key), std::string::npos);
    }
}

}  // namespace
}  // namespace tuftwave::server
