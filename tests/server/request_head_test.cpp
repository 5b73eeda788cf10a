#include "http/request_head.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tuftwave::server {
namespace {

RequestHead head(const std::string& method, const std::string& more, const std::string& version = "1.1") {
    return parse_head(method + " /x HTTP/" + version + "\r\nHost: h\r\n" + more + "\r\n");
}

int fault_of(const std::string& method, const std::string& more, const std::string& version = "1.1") {
    return head(method, more, version).fault;
}

TEST(RequestHead, SaysWhatWasAsked) {
    const RequestHead read =
        parse_head("POST /a%20b?c=1 HTTP/1.1\r\nHost: h:80\r\nX-Odd:  v\xC3\xA9 \t\r\nContent-Length: 12\r\n\r\n");
    EXPECT_EQ(read.fault, 0);
    EXPECT_EQ(read.request.method, "POST");
    EXPECT_EQ(read.request.path, "/a b");
    EXPECT_EQ(read.request.query, (NameValues{{"c", "1"}}));
    EXPECT_EQ(read.request.headers, (NameValues{{"host", "h:80"}, {"x-odd", "v\xC3\xA9"}, {"content-length", "12"}}));
    EXPECT_EQ(read.length, 12u);
    EXPECT_TRUE(read.has_body());
    EXPECT_FALSE(read.wants_close);
}

TEST(RequestHead, FirstLinesAreRefusedByTheirFirstFault) {
    EXPECT_EQ(fault_of_first_line("GET / HTTP/1.1"), 0);
    EXPECT_EQ(fault_of_first_line("OPTIONS / HTTP/1.0"), 0);
    for (const char* line :
         {"", "GET", "GET /", "GET  / HTTP/1.1", "GET /  HTTP/1.1", "GET / HTTP/1.1 ", " GET / HTTP/1.1",
          "GET / a HTTP/1.1", "GET / http/1.1", "GET / HTTP/1", "GET / HTTP/1.10", "GET / HTTP/a.1", "G(T / HTTP/1.1",
          "GET\t/ HTTP/1.1", "GET * HTTP/1.1", "GET http://h/ HTTP/1.1", "GET /%zz HTTP/1.1", "GET /#a HTTP/1.1"})
        EXPECT_EQ(fault_of_first_line(line), 400) << line;
    EXPECT_EQ(fault_of_first_line("GET / HTTP/2.0"), 505);
    EXPECT_EQ(fault_of_first_line("PRI * HTTP/2.0"), 505);
    for (const char* method : {"PUT", "DELETE", "get", "CONNECT", "TRACE", "GETS"})
        EXPECT_EQ(fault_of_first_line(std::string(method) + " / HTTP/1.1"), 501) << method;
    EXPECT_EQ(fault_of_first_line("GET /" + std::string(kMostTargetBytes - 1, 'a') + " HTTP/1.1"), 0);
    EXPECT_EQ(fault_of_first_line("GET /" + std::string(kMostTargetBytes, 'a') + " HTTP/1.1"), 414);
}

TEST(RequestHead, HeadersThatOthersMightReadOtherwiseAreRefused) {
    for (const char* line :
         {"X : 1", ": 1", "X", " X: 1", "\tX: 1", "X\x01: 1", "X: \x01", "X: \x7f", "X(: 1", "\xC3\xA9: 1"})
        EXPECT_EQ(fault_of("GET", std::string(line) + "\r\n"), 400) << line;
}

TEST(RequestHead, HostIsOneAndNothingElse) {
    EXPECT_EQ(parse_head("GET / HTTP/1.1\r\n\r\n").fault, 400);
    EXPECT_EQ(parse_head("GET / HTTP/1.0\r\n\r\n").fault, 0);
    EXPECT_EQ(fault_of("GET", "Host: h\r\n"), 400);
    EXPECT_EQ(fault_of("GET", "Host: h\r\n", "1.0"), 400);
    for (const char* host : {"a b", "a/b", "a@b", "a,b", "a\"", "\xC3\xA9"})
        EXPECT_EQ(parse_head("GET / HTTP/1.1\r\nHost: " + std::string(host) + "\r\n\r\n").fault, 400) << host;
    EXPECT_EQ(parse_head("GET / HTTP/1.1\r\nHost: [::1]:8080\r\n\r\n").fault, 0);
}

TEST(RequestHead, LengthsThatTwoReadersCouldReadTwoWaysAreRefused) {
    for (const char* length : {"", "-1", "+1", "1.0", "0x1", "1,1", "1 1", "%31"})
        EXPECT_EQ(fault_of("POST", "Content-Length: " + std::string(length) + "\r\n"), 400) << length;
    EXPECT_EQ(fault_of("POST", "Content-Length: 1\r\nContent-Length: 1\r\n"), 400);
    EXPECT_EQ(fault_of("POST", "Content-Length: 1\r\nTransfer-Encoding: chunked\r\n"), 400);
    EXPECT_EQ(fault_of("POST", "Transfer-Encoding: chunked\r\nTransfer-Encoding: chunked\r\n"), 400);
    for (const char* coding : {"", "gzip", "gzip, chunked", "chunked, chunked", "xchunked", "%63hunked", "identity"})
        EXPECT_EQ(fault_of("POST", "Transfer-Encoding: " + std::string(coding) + "\r\n"), 400) << coding;
    EXPECT_EQ(fault_of("POST", "Transfer-Encoding: chunked\r\n", "1.0"), 400);
    EXPECT_EQ(fault_of("POST", "Content-Length: 99999999999999999999\r\n"), 413);
    EXPECT_EQ(head("POST", "Content-Length: 9999999999999999999\r\n").length, 9'999'999'999'999'999'999u);
    EXPECT_EQ(head("POST", "Content-Length: 007\r\n").length, 7u);
    EXPECT_TRUE(head("POST", "Transfer-Encoding: Chunked\r\n").is_chunked);
}

TEST(RequestHead, BodiesAreForPostAndNeedALength) {
    EXPECT_EQ(fault_of("POST", ""), 411);
    EXPECT_EQ(fault_of("POST", "Content-Length: 0\r\n"), 0);
    for (const char* method : {"GET", "HEAD", "OPTIONS"}) {
        EXPECT_EQ(fault_of(method, "Content-Length: 1\r\n"), 400) << method;
        EXPECT_EQ(fault_of(method, "Transfer-Encoding: chunked\r\n"), 400) << method;
        EXPECT_EQ(fault_of(method, "Content-Length: 0\r\n"), 0) << method;
    }
}

TEST(RequestHead, CodingsAndExpectationsThatAreNotMet) {
    EXPECT_EQ(fault_of("POST", "Content-Length: 1\r\nContent-Encoding: gzip\r\n"), 415);
    EXPECT_EQ(fault_of("POST", "Content-Length: 1\r\nContent-Encoding: identity\r\nContent-Encoding: br\r\n"), 415);
    EXPECT_EQ(fault_of("POST", "Content-Length: 1\r\nContent-Encoding: Identity\r\n"), 0);
    EXPECT_EQ(fault_of("POST", "Content-Length: 1\r\nExpect: the best\r\n"), 417);
    EXPECT_TRUE(head("POST", "Content-Length: 1\r\nExpect: 100-Continue\r\n").expects_continue);
    EXPECT_FALSE(head("POST", "Content-Length: 1\r\nExpect: 100-continue\r\n", "1.0").expects_continue);
}

TEST(RequestHead, KnowsWhoWantsToGo) {
    EXPECT_TRUE(head("GET", "Connection: Close\r\n").wants_close);
    EXPECT_TRUE(head("GET", "Connection: keep-alive, close\r\n").wants_close);
    EXPECT_TRUE(head("GET", "Connection: keep-alive\r\n", "1.0").wants_close);
    EXPECT_FALSE(head("GET", "Connection: closed\r\n").wants_close);
}

TEST(RequestHead, TakesAsManyHeadersAsAreAllowed) {
    std::string more;
    for (std::size_t i = 1; i < kMostHeaders; ++i) more += "X: 1\r\n";
    EXPECT_EQ(fault_of("GET", more), 0);
    EXPECT_EQ(fault_of("GET", more + "X: 1\r\n"), 431);
}

}  // namespace
}  // namespace tuftwave::server
