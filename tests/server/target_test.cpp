#include "http/target.hpp"

#include <gtest/gtest.h>

namespace tuftwave::server {
namespace {

TEST(Target, IsDecodedInItsOrder) {
    const auto target = parse_target("/a%2fb+c?b=1&a=%26+2&b&=3&&c=4=5");
    ASSERT_TRUE(target);
    EXPECT_EQ(target->path, "/a/b+c");
    EXPECT_EQ(target->query, (NameValues{{"b", "1"}, {"a", "& 2"}, {"b", ""}, {"", "3"}, {"c", "4=5"}}));
    EXPECT_EQ(parse_target("/")->path, "/");
    EXPECT_TRUE(parse_target("/?")->query.empty());
}

TEST(Target, ThatIsNoPathOrBadlyEncodedIsNone) {
    for (const char* target : {"", "*", "a", "http://h/", "/%", "/%4", "/%4g", "/%-1", "/?a=%", "/?%=a", "/% 1", "/a b",
                               "/#", "/?a#b", "/%00", "/a\x01", "/\xC3\xA9", "/\x7f"})
        EXPECT_FALSE(parse_target(target)) << target;
}

}  // namespace
}  // namespace tuftwave::server
