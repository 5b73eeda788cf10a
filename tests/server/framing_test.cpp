#include "http/framing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tuftwave::server {
namespace {

constexpr std::size_t kLimit = 100;

/// Gives out a text in pieces of at most `piece` bytes, then ends. Whatever is left in it was not read.
ByteSource source(std::string& text, const std::size_t piece = 7) {
    return [&text, piece](char* to, const std::size_t count) {
        const std::size_t part = std::min({count, piece, text.size()});
        std::copy_n(text.data(), part, to);
        text.erase(0, part);
        return static_cast<std::ptrdiff_t>(part);
    };
}

Body body(const std::string& sent, const Framing& framing, std::string* left = nullptr) {
    std::string rest = sent;
    Body read = read_body(source(rest), framing, kLimit);
    if (left) *left = rest;
    return read;
}

Framing chunked() { return {0, true, 0}; }
Framing length(const std::uint64_t bytes) { return {0, false, bytes}; }

Framing framing(const std::string& method, NameValues headers, const bool is_http_1_0 = false) {
    headers.emplace_back("host", "h");
    return framing_of({method, "/", {}, std::move(headers), ""}, is_http_1_0);
}

TEST(Framing, TargetIsDecodedInItsOrder) {
    const auto target = parse_target("/a%2fb+c?b=1&a=%26+2&b&=3&&c=4=5");
    ASSERT_TRUE(target);
    EXPECT_EQ(target->path, "/a/b+c");
    EXPECT_EQ(target->query, (NameValues{{"b", "1"}, {"a", "& 2"}, {"b", ""}, {"", "3"}, {"c", "4=5"}}));
    EXPECT_EQ(parse_target("/")->path, "/");
    EXPECT_TRUE(parse_target("/?")->query.empty());
}

TEST(Framing, TargetThatIsNoPathOrBadlyEncodedIsNone) {
    for (const char* target : {"", "*", "a", "http://h/", "/%", "/%4", "/%4g", "/%-1", "/?a=%", "/?%=a", "/% 1"})
        EXPECT_FALSE(parse_target(target)) << target;
}

TEST(Framing, SoundRequests) {
    EXPECT_EQ(framing("POST", {{"content-length", "12"}}).length, 12u);
    EXPECT_EQ(framing("POST", {{"content-length", "12"}}).fault, 0);
    EXPECT_TRUE(framing("POST", {{"transfer-encoding", "Chunked"}}).is_chunked);
    EXPECT_EQ(framing("POST", {{"transfer-encoding", "Chunked"}}).fault, 0);
    EXPECT_EQ(framing("DELETE", {}).fault, 0);
    EXPECT_EQ(framing("GET", {{"content-length", "0"}}).fault, 0);
    EXPECT_EQ(framing("POST", {{"content-length", "1"}, {"content-encoding", "Identity"}}).fault, 0);
    EXPECT_EQ(framing_of({"GET", "/", {}, {}, ""}, true).fault, 0) << "HTTP/1.0 knows no Host";
}

TEST(Framing, DoubtfulLengthsAreRefused) {
    for (const char* length : {"", "-1", "+1", "1.0", "0x1", " 1", "1 ", "1,1", "99999999999999999999"})
        EXPECT_EQ(framing("POST", {{"content-length", length}}).fault, 400) << length;
    EXPECT_EQ(framing("POST", {{"transfer-encoding", "chunked"}}, true).fault, 400) << "HTTP/1.0 knows no chunks";
    EXPECT_EQ(framing("OPTIONS", {{"transfer-encoding", "chunked"}}).fault, 400);
}

TEST(Framing, BodyWithLengthStopsThere) {
    std::string left;
    const Body read = body("0123456789next", length(10), &left);
    EXPECT_EQ(read.fault, 0);
    EXPECT_TRUE(read.is_over);
    EXPECT_EQ(read.bytes, "0123456789");
    EXPECT_EQ(left, "next");
}

TEST(Framing, BodyThatEndsEarlyIsBad) {
    EXPECT_EQ(body("012", length(10)).fault, 400);
    EXPECT_FALSE(body("012", length(10)).is_over);
    for (const char* sent : {"", "3", "3\r\n", "3\r\nab", "3\r\nabc", "3\r\nabc\r\n", "3\r\nabc\r\n0\r\n"})
        EXPECT_EQ(body(sent, chunked()).fault, 400) << sent;
}

TEST(Framing, ChunksAreJoinedAndTrailersSkipped) {
    std::string left;
    const Body read = body("3\r\nabc\r\n00A;x=y\r\n0123456789\r\n0\r\nT: 1\r\n\r\nnext", chunked(), &left);
    EXPECT_EQ(read.fault, 0);
    EXPECT_EQ(read.bytes, "abc0123456789");
    EXPECT_EQ(left, "next");
}

TEST(Framing, BadChunksAreRefused) {
    const std::string endless(1'000, '0');
    for (const std::string sent : {"g\r\n", "-1\r\n", "\r\n", " 1\r\na\r\n0\r\n\r\n", "1\na\r\n0\r\n\r\n",
                                   "1\r\nab\r\n0\r\n\r\n", "1\r\na0\r\n\r\n", "10000000000000000\r\n", endless.c_str()})
        EXPECT_EQ(body(sent, chunked()).fault, 400) << sent;
}

TEST(Framing, EndlessTrailersAreRefused) {
    std::string sent = "0\r\n";
    for (int i = 0; i < 100; ++i) sent += "T: 1\r\n";
    EXPECT_EQ(body(sent + "\r\n", chunked()).fault, 400);
}

TEST(Framing, BodyOverTheLimitIsReadToItsEndButNotKept) {
    std::string left;
    const Body read = body(std::string(kLimit + 1, 'x') + "next", length(kLimit + 1), &left);
    EXPECT_EQ(read.fault, 413);
    EXPECT_TRUE(read.is_over);
    EXPECT_EQ(read.bytes, "");
    EXPECT_EQ(left, "next");
    EXPECT_EQ(body(std::string(kLimit, 'x'), length(kLimit)).fault, 0);
}

TEST(Framing, BodyFarOverTheLimitIsNotReadAtAll) {
    std::string left;
    const Body read = body("abc", length(4 * kLimit + 1), &left);
    EXPECT_EQ(read.fault, 413);
    EXPECT_FALSE(read.is_over);
    EXPECT_EQ(left, "abc");
}

TEST(Framing, ChunksFarOverTheLimitAreGivenUp) {
    std::string left;
    const Body read = body("ffffffff\r\n" + std::string(10 * kLimit, 'x'), chunked(), &left);
    EXPECT_EQ(read.fault, 413);
    EXPECT_FALSE(read.is_over);
    EXPECT_GT(left.size(), 5 * kLimit);
}

}  // namespace
}  // namespace tuftwave::server
