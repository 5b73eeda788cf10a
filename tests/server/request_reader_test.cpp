#include "http/request_reader.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tuftwave::server {
namespace {

using Step = RequestReader::Step;

constexpr std::size_t kMost = 1'000;

struct Read {
    std::vector<Request> requests;
    int refusal = 0;
    bool has_begun = false;
};

/// All requests of a text that comes in pieces of `piece` bytes.
Read read(const std::string& text, const std::size_t piece) {
    RequestReader reader;
    Read result;
    for (std::size_t at = 0; at < text.size() && result.refusal == 0; at += piece) {
        std::string_view bytes = std::string_view(text).substr(at, piece);
        for (Step step; (step = reader.take(bytes)) != Step::kWantsMore && result.refusal == 0;) {
            if (step == Step::kHead) reader.allow_body(kMost);
            if (step == Step::kRequest) result.requests.push_back(reader.take_request());
            if (step == Step::kRefused) result.refusal = reader.refusal();
        }
    }
    result.has_begun = reader.has_begun();
    return result;
}

int refusal_of(const std::string& text) {
    const int refusal = read(text, text.size()).refusal;
    EXPECT_EQ(read(text, 1).refusal, refusal) << text;
    return refusal;
}

TEST(RequestReader, FindsTheSameRequestsHoweverTheBytesAreSplit) {
    const std::string text =
        "GET /1 HTTP/1.1\r\nHost: h\r\n\r\n"
        "POST /2 HTTP/1.1\r\nHost: h\r\nContent-Length: 3\r\n\r\nabc"
        "POST /3 HTTP/1.1\r\nHost: h\r\nTransfer-Encoding: chunked\r\n\r\n2\r\nde\r\n0\r\n\r\n"
        "POST /4 HTTP/1.1\r\nHost: h\r\nContent-Length: 0\r\n\r\n";
    for (std::size_t piece = 1; piece <= text.size(); ++piece) {
        const Read got = read(text, piece);
        ASSERT_EQ(got.requests.size(), 4u) << piece;
        EXPECT_EQ(got.requests[1].path + got.requests[1].body, "/2abc");
        EXPECT_EQ(got.requests[2].path + got.requests[2].body, "/3de");
        EXPECT_EQ(got.requests[3].path + got.requests[3].body, "/4");
        EXPECT_FALSE(got.has_begun);
    }
}

TEST(RequestReader, HeadsThatCanNeverBecomeOneAreRefusedAtOnce) {
    EXPECT_EQ(refusal_of("\r\n"), 400);
    EXPECT_EQ(refusal_of("\n"), 400);
    EXPECT_EQ(refusal_of("GET / HTTP/1.1\n"), 400);
    EXPECT_EQ(refusal_of("GET / HTTP/1.1\rX"), 400);
    EXPECT_EQ(refusal_of(std::string("GET /\0", 6)), 400);
    EXPECT_EQ(refusal_of("\x16\x03\x01"), 400);  // the begin of TLS
    EXPECT_EQ(refusal_of("BREW / HTTP/1.1\r\n"), 501);
    EXPECT_EQ(refusal_of("GET / HTTP/1.1\r\nHost: h\nX: y\r\n"), 400);
}

TEST(RequestReader, HeadsThatNeverEndAreRefused) {
    EXPECT_EQ(refusal_of(std::string(kMostFirstLineBytes + 1, 'x')), 414);
    EXPECT_EQ(refusal_of("GET / HTTP/1.1\r\nX: " + std::string(kMostHeadBytes, 'x')), 431);
    std::string many = "GET / HTTP/1.1\r\nHost: h\r\n";
    for (std::size_t i = 0; i < kMostHeaders; ++i) many += "X: 1\r\n";
    EXPECT_EQ(refusal_of(many), 431);
}

TEST(RequestReader, BodiesOverTheLimitAreRefusedBeforeTheyAreRead) {
    EXPECT_EQ(refusal_of("POST / HTTP/1.1\r\nHost: h\r\nContent-Length: 1001\r\n\r\n"), 413);
    EXPECT_EQ(refusal_of("POST / HTTP/1.1\r\nHost: h\r\nTransfer-Encoding: chunked\r\n\r\n3e9\r\n"), 413);
    EXPECT_EQ(refusal_of("POST / HTTP/1.1\r\nHost: h\r\nTransfer-Encoding: chunked\r\n\r\nx\r\n"), 400);
}

TEST(RequestReader, KnowsHowFarItIs) {
    RequestReader reader;
    EXPECT_FALSE(reader.has_begun());
    std::string_view bytes = "POST / HTTP/1.1\r\nHost: h\r\nContent-Length: 5\r\n\r\nab";
    EXPECT_EQ(reader.take(bytes), Step::kHead);
    EXPECT_TRUE(reader.has_begun());
    EXPECT_EQ(bytes, "ab");
    reader.allow_body(kMost);
    EXPECT_TRUE(reader.is_in_body());
    EXPECT_EQ(reader.take(bytes), Step::kWantsMore);
    EXPECT_EQ(reader.body_bytes(), 2u);
    EXPECT_EQ(reader.body_bytes_left(), 3u);
}

TEST(RequestReader, RequestWithoutABodyCanBeSkipped) {
    RequestReader reader;
    std::string_view bytes = "GET /1 HTTP/1.1\r\nHost: h\r\n\r\nGET /2 HTTP/1.1\r\nHost: h\r\n\r\n";
    EXPECT_EQ(reader.take(bytes), Step::kHead);
    reader.skip_body();
    EXPECT_EQ(reader.take(bytes), Step::kHead);
    EXPECT_EQ(reader.head().request.path, "/2");
}

}  // namespace
}  // namespace tuftwave::server
