#include "http/library.hpp"

#include <gtest/gtest.h>

namespace tuftwave::server {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Library, WordsAnAnswerAndLeavesItsBodyApart) {
    const Message message = Library().message("POST", {200, "text/plain", "body", {{"X-Mine", "1"}}}, false);
    EXPECT_TRUE(message.head.starts_with("HTTP/1.1 200 OK\r\n")) << message.head;
    for (const char* line : {"Content-Type: text/plain\r\n", "Content-Length: 4\r\n", "X-Mine: 1\r\n",
                             "X-Content-Type-Options: nosniff\r\n"})
        EXPECT_TRUE(has(message.head, line)) << message.head;
    EXPECT_TRUE(message.head.ends_with("\r\n\r\n"));
    EXPECT_FALSE(has(message.head, "Connection")) << message.head;
    EXPECT_FALSE(has(message.head, "Keep-Alive")) << message.head;
    EXPECT_EQ(message.body, "body");
}

TEST(Library, DoesNotCopyTheBody) {
    std::string body(1'000'000, 'x');
    const char* const place = body.data();
    EXPECT_EQ(Library().message("GET", {200, "model/gltf-binary", std::move(body), {}}, false).body.data(), place);
}

TEST(Library, BytesOfTheProgramStayWhereTheyAre) {
    static constexpr std::string_view kPage = "<!doctype html>";
    const Message message = Library().message("GET", {200, "text/html", "", {}, kPage}, false);
    EXPECT_TRUE(has(message.head, "Content-Length: 15\r\n")) << message.head;
    EXPECT_FALSE(has(message.head, "Content-Length: 0")) << message.head;
    EXPECT_EQ(message.content().data(), kPage.data());
    EXPECT_EQ(message.size(), message.head.size() + kPage.size());
    EXPECT_EQ(message.memory(), message.head.size());
    const Message head = Library().message("HEAD", {200, "text/html", "", {}, kPage}, false);
    EXPECT_TRUE(has(head.head, "Content-Length: 15\r\n")) << head.head;
    EXPECT_EQ(head.content(), "");
}

TEST(Library, HeadHasTheLengthOfTheBodyAndNoBody) {
    const Message message = Library().message("HEAD", {200, "application/json", std::string(5'000, ' '), {}}, false);
    EXPECT_TRUE(has(message.head, "Content-Length: 5000\r\n")) << message.head;
    EXPECT_FALSE(has(message.head, "Accept-Ranges")) << message.head;
    EXPECT_EQ(message.body, "");
}

TEST(Library, StatusesOfOurOwnHaveTheirNames) {
    const Library library;
    const std::pair<int, const char*> names[]{{400, "Bad Request"},       {405, "Method Not Allowed"},
                                              {408, "Request Timeout"},   {413, "Payload Too Large"},
                                              {429, "Too Many Requests"}, {431, "Request Header Fields Too Large"},
                                              {501, "Not Implemented"},   {503, "Service Unavailable"},
                                              {504, "Gateway Timeout"},   {505, "HTTP Version Not Supported"}};
    for (const auto& [status, name] : names) {
        const Message message = library.message("GET", {status, "application/problem+json", "mine", {}}, true);
        EXPECT_TRUE(message.head.starts_with("HTTP/1.1 " + std::to_string(status) + " " + name + "\r\n"))
            << message.head;
        EXPECT_TRUE(has(message.head, "Connection: close\r\n")) << message.head;
        EXPECT_EQ(message.body, "mine") << status;
    }
}

TEST(Library, NoHeaderBecomesTwo) {
    const Message message = Library().message(
        "GET", {200, "text/plain", "", {{"X-Mine", "1\r\nX-Theirs: 2"}, {"X-\nTheirs", "2"}, {"X-Last", "3"}}}, false);
    EXPECT_FALSE(has(message.head, "Theirs")) << message.head;
    EXPECT_TRUE(has(message.head, "X-Last: 3\r\n")) << message.head;
}

TEST(Library, AnswersWithoutContentHaveNoLength) {
    for (const int status : {204, 304})
        EXPECT_FALSE(has(Library().message("GET", {status, "", "", {}}, false).head, "Content-Length")) << status;
}

}  // namespace
}  // namespace tuftwave::server
