#include "access/digest.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace tuftwave::server {
namespace {

std::string hex(const Digest& digest) {
    std::string text;
    for (const unsigned char byte : digest) {
        char digits[3];
        std::snprintf(digits, sizeof digits, "%02x", byte);
        text += digits;
    }
    return text;
}

TEST(Digest, IsSha256) {  // the first two examples of FIPS 180-4
    EXPECT_EQ(hex(sha256("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(hex(sha256("")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Digest, EveryBitCountsInAComparison) {
    const Digest digest = sha256("abc");
    EXPECT_TRUE(equal_in_constant_time(digest, sha256("abc")));
    for (std::size_t bit = 0; bit < 8 * digest.size(); ++bit) {
        Digest other = digest;
        other[bit / 8] ^= static_cast<unsigned char>(1 << bit % 8);
        EXPECT_FALSE(equal_in_constant_time(digest, other)) << bit;
    }
}

}  // namespace
}  // namespace tuftwave::server
