#include "api/studio.hpp"

#include <gtest/gtest.h>

#include <string>

#include "assets/assets.hpp"
#include "support.hpp"

namespace tuftwave::server {
namespace {

constexpr std::string_view kPage = "<!doctype html><title>made up</title>";

/// A studio of one file of each kind.
std::optional<std::string_view> with_studio(const std::string_view name) {
    if (name == "studio/index.html") return kPage;
    for (const char* ending : {"js", "css", "json", "glb", "svg", "png", "webp", "woff2", "txt", "bin"}) {
        if (name == std::string("studio/studio.") + ending) return "bytes";
    }
    if (name == "openapi.yaml") return "not a file of the studio";
    return {};
}

std::optional<std::string_view> without_studio(std::string_view) { return {}; }

Answer root(FindAsset find, const NameValues& headers = {}) {
    static const Limits limits;
    return answer_root({"GET", "/", {}, headers, ""}, {limits, InOrder(), {}}, find);
}

Answer file(const std::string& name, const NameValues& headers = {}) {
    return answer_studio_file({"GET", "/studio/" + name, {}, headers, ""}, with_studio);
}

std::string header_of(const Answer& answer, const std::string& name) {
    for (const auto& [key, value] : std::get<Response>(answer).headers) {
        if (key == name) return value;
    }
    return "";
}

TEST(Studio, RootIsItsPageWhereItWasBuiltIn) {
    const Answer answer = root(with_studio);
    const auto& response = std::get<Response>(answer);
    EXPECT_EQ(response.status, 200);
    EXPECT_EQ(response.content_type, "text/html; charset=utf-8");
    EXPECT_EQ(response.content(), kPage);
    EXPECT_EQ(std::get<Response>(file("index.html")).content(), kPage);
}

TEST(Studio, RootIsThePageOfDocsWhereItWasNot) {
    const auto docs = std::get<Response>(answer_to({"GET", "/docs", {}, {}, ""}));
    const Answer answer = root(without_studio);
    const auto& response = std::get<Response>(answer);
    EXPECT_EQ(response.status, 200);
    EXPECT_EQ(response.content_type, docs.content_type);
    EXPECT_EQ(response.content(), docs.content());
    EXPECT_EQ(header_of(answer, "Cache-Control"), "no-cache");
    EXPECT_NE(header_of(answer, "ETag"), "");
}

TEST(Studio, FilesSayWhatTheyAre) {
    const std::pair<const char*, const char*> kExpected[] = {{"index.html", "text/html; charset=utf-8"},
                                                             {"studio.js", "text/javascript; charset=utf-8"},
                                                             {"studio.css", "text/css; charset=utf-8"},
                                                             {"studio.json", "application/json"},
                                                             {"studio.glb", "model/gltf-binary"},
                                                             {"studio.svg", "image/svg+xml"},
                                                             {"studio.png", "image/png"},
                                                             {"studio.webp", "image/webp"},
                                                             {"studio.woff2", "font/woff2"},
                                                             {"studio.txt", "text/plain; charset=utf-8"},
                                                             {"studio.bin", "application/octet-stream"}};
    for (const auto& [name, type] : kExpected) {
        const Answer answer = file(name);
        ASSERT_TRUE(std::holds_alternative<Response>(answer)) << name;
        EXPECT_EQ(std::get<Response>(answer).content_type, type) << name;
        EXPECT_EQ(header_of(answer, "Cache-Control"), "no-cache") << name;
    }
}

TEST(Studio, WhoeverHasAFileGetsNoBody) {
    for (const char* name : {"index.html", "studio.js"}) {
        const std::string tag = header_of(file(name), "ETag");
        ASSERT_TRUE(tag.starts_with('"') && tag.ends_with('"')) << tag;
        for (const std::string& had : {tag, "\"0\", " + tag, std::string("*")}) {
            const Answer answer = file(name, {{"if-none-match", had}});
            EXPECT_EQ(std::get<Response>(answer).status, 304) << had;
            EXPECT_EQ(std::get<Response>(answer).content(), "") << had;
            EXPECT_EQ(header_of(answer, "ETag"), tag);
        }
        EXPECT_EQ(std::get<Response>(file(name, {{"if-none-match", "\"0\""}})).status, 200);
    }
    EXPECT_NE(header_of(file("index.html"), "ETag"), header_of(file("studio.js"), "ETag"));
    for (const FindAsset find : {with_studio, without_studio}) {
        const std::string tag = header_of(root(find), "ETag");
        EXPECT_EQ(std::get<Response>(root(find, {{"if-none-match", tag}})).status, 304);
    }
}

TEST(Studio, OnlyItsPagesMayRunScriptsAndOnlyItsOwn) {
    for (const Answer& answer : {root(with_studio), file("index.html")}) {
        const std::string policy = "; " + header_of(answer, "Content-Security-Policy") + ";";
        for (const char* part :
             {"; default-src 'self';", "; script-src 'self';", "; object-src 'none';", "; base-uri 'none';"})
            EXPECT_NE(policy.find(part), std::string::npos) << part << " in " << policy;
        EXPECT_EQ(policy.find("http"), std::string::npos) << policy;
    }
    EXPECT_EQ(header_of(file("studio.js"), "Content-Security-Policy"), "");
}

TEST(Studio, WhatIsNotOfItIsNotFound) {
    for (const char* name :
         {"nothing.js", "openapi.yaml", "studio", "studio.j", "..", "INDEX.HTML", "studio/index.html"})
        EXPECT_EQ(slug_of(file(name)), "not_found") << name;
    EXPECT_EQ(slug_of(answer_studio_file({"GET", "/studio/index.html", {}, {}, ""}, without_studio)), "not_found");
    for (const char* path : {"/studio", "/studio/", "/studio/../openapi.yaml", "/studio/openapi.yaml"})
        EXPECT_EQ(slug_of(answer_to({"GET", path, {}, {}, ""})), "not_found") << path;
}

/// Whichever of the two this program is: the routes answer with what was built in.
TEST(Studio, RoutesServeWhatWasBuiltIn) {
    const auto page = asset("studio/index.html");
    for (const char* method : {"GET", "HEAD"}) {
        const Answer at_root = answer_to({method, "/", {}, {}, ""});
        const Answer at_file = answer_to({method, "/studio/index.html", {}, {}, ""});
        if (page) {
            EXPECT_EQ(std::get<Response>(at_root).content(), *page);
            EXPECT_EQ(std::get<Response>(at_file).content(), *page);
        } else {
            EXPECT_EQ(std::get<Response>(at_root).content(),
                      std::get<Response>(answer_to({"GET", "/docs", {}, {}, ""})).content());
            EXPECT_EQ(slug_of(at_file), "not_found");
        }
    }
}

}  // namespace
}  // namespace tuftwave::server
