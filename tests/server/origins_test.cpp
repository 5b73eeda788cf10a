#include "access/origins.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

namespace tuftwave::server {
namespace {

Origins origins(const std::string& list) {
    const auto made = Origins::parse(list);
    if (const auto* error = std::get_if<std::string>(&made)) ADD_FAILURE() << *error;
    return std::holds_alternative<Origins>(made) ? std::get<Origins>(made) : Origins{};
}

bool is_refused(const std::string& list) { return std::holds_alternative<std::string>(Origins::parse(list)); }

Request request(const std::string& method, const NameValues& headers) {
    return {method, "/v1/limits", {}, headers, ""};
}

Request from(const std::string& origin) { return request("GET", {{"origin", origin}}); }

/// All values of a header, each followed by a line break.
std::string all(const Response& response, const std::string& name) {
    std::string values;
    for (const auto& [each, value] : response.headers)
        if (each == name) values += value + "\n";
    return values;
}

/// What an answer gets, as its only headers.
Response dressed(const Origins& origins, const Request& request) {
    Response response;
    origins.add_headers(request, response);
    return response;
}

const std::string kStudio = "https://studio.example";

TEST(Origins, AreWrittenAsBrowsersSendThem) {
    for (const char* good : {"", "  ", "https://studio.example", "http://localhost:5173", "http://127.0.0.1:1",
                             "http://[::1]:5173", "https://[2001:db8::1]", "https://a.example , http://b.example:8080"})
        EXPECT_FALSE(is_refused(good)) << good;
    for (const char* bad : {"*",
                            "null",
                            "studio.example",
                            "https://",
                            "https://*.example",
                            "https://studio.example/",
                            "https://Studio.example",
                            "HTTPS://studio.example",
                            "ftp://studio.example",
                            "https://studio.example:443",
                            "http://studio.example:80",
                            "https://studio.example:",
                            "https://studio.example:0",
                            "https://studio.example:65536",
                            "https://studio.example:08",
                            "https://studio.example:+8",
                            "https://user@studio.example",
                            "https://studio.example?",
                            "https://a b",
                            "https://[::1",
                            "https://[]",
                            "https://[::1]x",
                            "https://a.example,",
                            ",https://a.example",
                            "https://a.example,,https://b.example",
                            "https://a.example\r\nX: y"})
        EXPECT_TRUE(is_refused(bad)) << bad;
}

TEST(Origins, OffSaysNothingAtAll) {
    const Origins off = origins("");
    EXPECT_FALSE(off.is_on());
    EXPECT_TRUE(dressed(off, from(kStudio)).headers.empty());
    EXPECT_FALSE(
        off.is_preflight(request("OPTIONS", {{"origin", kStudio}, {"access-control-request-method", "POST"}})));
}

TEST(Origins, ListedPageMayReadTheAnswer) {
    const Origins on = origins("http://localhost:5173," + kStudio);
    for (const std::string& origin : {kStudio, std::string("http://localhost:5173")}) {
        const Response response = dressed(on, from(origin));
        EXPECT_EQ(all(response, "Access-Control-Allow-Origin"), origin + "\n");
        EXPECT_EQ(all(response, "Vary"), "Origin\n");
        const std::string exposed = all(response, "Access-Control-Expose-Headers");
        for (const char* name : {"ETag", "Retry-After", "Content-Disposition", "Request-Id", "Tuftwave-Frame-Rate"})
            EXPECT_NE(exposed.find(name), std::string::npos) << name;
        EXPECT_EQ(all(response, "Access-Control-Allow-Credentials"), "");
    }
}

TEST(Origins, AnotherPageMayNot) {
    const Origins on = origins(kStudio);
    for (const std::string origin :
         {"https://studio.example.evil", "https://evil-studio.example", "http://studio.example",
          "https://studio.example:444", "https://STUDIO.example", "null", "*", "https://studio.exampl"}) {
        const Response response = dressed(on, from(origin));
        EXPECT_EQ(response.headers, (NameValues{{"Vary", "Origin"}})) << origin;
    }
    const Request twice = request("GET", {{"origin", kStudio}, {"origin", "https://evil.example"}});
    EXPECT_EQ(dressed(on, twice).headers, (NameValues{{"Vary", "Origin"}}));
    EXPECT_EQ(dressed(on, request("GET", {})).headers, (NameValues{{"Vary", "Origin"}}));
}

TEST(Origins, ThereIsOneVaryHeader) {
    Response response;
    response.headers = {{"Vary", "Accept"}};
    origins(kStudio).add_headers(from(kStudio), response);
    EXPECT_EQ(all(response, "Vary"), "Accept, Origin\n");
}

TEST(Origins, PreflightIsAnsweredByWhatIsAllowed) {
    const Origins on = origins(kStudio);
    const Request asked = request("OPTIONS", {{"origin", kStudio}, {"access-control-request-method", "POST"}});
    ASSERT_TRUE(on.is_preflight(asked));
    const Response response = on.preflight(asked, "POST, OPTIONS");
    EXPECT_EQ(response.status, 204);
    EXPECT_EQ(response.body, "");
    EXPECT_EQ(all(response, "Access-Control-Allow-Origin"), kStudio + "\n");
    EXPECT_EQ(all(response, "Access-Control-Allow-Methods"), "POST, OPTIONS\n");
    EXPECT_EQ(all(response, "Access-Control-Allow-Headers"), "Authorization, Content-Type, Accept, If-None-Match\n");
    EXPECT_EQ(all(response, "Access-Control-Max-Age"), "7200\n");
    EXPECT_EQ(all(response, "Vary"), "Origin\n");
    EXPECT_EQ(all(response, "Allow"), "POST, OPTIONS\n");
    Response again = response;
    on.add_headers(asked, again);
    EXPECT_EQ(again.headers, response.headers);

    const Request stranger =
        request("OPTIONS", {{"origin", "https://evil.example"}, {"access-control-request-method", "POST"}});
    ASSERT_TRUE(on.is_preflight(stranger));
    EXPECT_EQ(on.preflight(stranger, "POST, OPTIONS").headers,
              (NameValues{{"Allow", "POST, OPTIONS"}, {"Vary", "Origin"}}));
}

TEST(Origins, OptionsAloneIsNoPreflight) {
    const Origins on = origins(kStudio);
    EXPECT_FALSE(on.is_preflight(request("OPTIONS", {})));
    EXPECT_FALSE(on.is_preflight(request("OPTIONS", {{"origin", kStudio}})));
    EXPECT_FALSE(on.is_preflight(request("OPTIONS", {{"access-control-request-method", "POST"}})));
    EXPECT_FALSE(on.is_preflight(request("POST", {{"origin", kStudio}, {"access-control-request-method", "POST"}})));
}

}  // namespace
}  // namespace tuftwave::server
