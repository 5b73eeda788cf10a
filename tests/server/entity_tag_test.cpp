#include "api/entity_tag.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace tuftwave::server {
namespace {

std::string tag_of(const std::string& body) {
    return with_entity_tag({200, "text/plain", body, {}}, {"GET", "/", {}, {}, ""}).headers.at(0).second;
}

TEST(EntityTag, TellsEveryByteAndEveryLengthApart) {
    std::set<std::string> tags;
    std::size_t bodies = 0;
    for (std::size_t length = 0; length <= 20; ++length) {
        const std::string zeros(length, '\0');
        tags.insert(tag_of(zeros));
        ++bodies;
        for (std::size_t at = 0; at < length; ++at, ++bodies) {
            std::string other = zeros;
            other[at] = '\x01';
            tags.insert(tag_of(other));
        }
    }
    EXPECT_EQ(tags.size(), bodies);
    EXPECT_EQ(tag_of("hair"), tag_of("hair"));
}

TEST(EntityTag, BytesOfTheProgramHaveTheTagOfTheirContent) {
    static constexpr std::string_view kConstant = "hair, and more";
    for (const std::size_t length : {kConstant.size(), std::size_t{4}, kConstant.size()}) {
        const std::string_view part = kConstant.substr(0, length);
        const Response answer = with_entity_tag({200, "text/plain", "", {}, part}, {"GET", "/", {}, {}, ""});
        EXPECT_EQ(answer.headers.at(0).second, tag_of(std::string(part)));
        EXPECT_EQ(answer.content().data(), part.data());
        const Request again{"GET", "/", {}, {{"if-none-match", answer.headers.at(0).second}}, ""};
        EXPECT_EQ(with_entity_tag({200, "text/plain", "", {}, part}, again).content(), "");
    }
}

TEST(EntityTag, IsOfWhatIsSent) {
    for (const std::string before : {"", "a", "whatever"}) {
        const Response answer{200, "text/plain", before + "hair", {}, {}, before.size()};
        const Response first = with_entity_tag(answer, {"GET", "/", {}, {}, ""});
        EXPECT_EQ(first.headers.at(0).second, tag_of("hair"));
        EXPECT_EQ(first.content(), "hair");
        EXPECT_EQ(with_entity_tag(answer, {"GET", "/", {}, {{"if-none-match", tag_of("hair")}}, ""}).content(), "");
    }
}

TEST(EntityTag, WhoHasItIsToldSo) {
    const std::string tag = tag_of("hair");
    for (const std::string& known : {tag, "\"other\", " + tag, std::string("*")}) {
        const Response answer =
            with_entity_tag({200, "text/plain", "hair", {}}, {"GET", "/", {}, {{"if-none-match", known}}, ""});
        EXPECT_EQ(answer.status, 304) << known;
        EXPECT_EQ(answer.body, "") << known;
    }
    EXPECT_EQ(
        with_entity_tag({200, "text/plain", "hair", {}}, {"GET", "/", {}, {{"if-none-match", "\"x\""}}, ""}).status,
        200);
}

}  // namespace
}  // namespace tuftwave::server
