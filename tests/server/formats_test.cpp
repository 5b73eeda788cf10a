#include "api/formats.hpp"

#include <gtest/gtest.h>

namespace tuftwave::server {
namespace {

std::string chosen(const std::string& accept, const NameValues& query = {}) {
    const auto format =
        choose_format({"POST", "/", query, {{"accept", accept}}, ""}, {Format::kGlb, Format::kGltf, Format::kJson});
    if (const auto* problem = std::get_if<Problem>(&format)) return slug(problem->code);
    return formatted(std::get<Format>(format), "", "hair", nullptr).content_type;
}

TEST(Formats, AcceptDecidesByQualityAndThenByOurOrder) {
    EXPECT_EQ(chosen(""), "model/gltf-binary");
    EXPECT_EQ(chosen("*/*"), "model/gltf-binary");
    EXPECT_EQ(chosen("application/json"), "application/json");
    EXPECT_EQ(chosen("model/gltf-binary;q=0.1, model/gltf+json"), "model/gltf+json");
    EXPECT_EQ(chosen("model/*;q=0.5, application/json;q=0.4"), "model/gltf-binary");
    EXPECT_EQ(chosen("model/gltf-binary;q=0, */*"), "model/gltf+json");  // the exact range wins over the wild one
    EXPECT_EQ(chosen("text/html, application/json ; q=0.9"), "application/json");
    EXPECT_EQ(chosen("image/png"), "not_acceptable");
    EXPECT_EQ(chosen("application/json;q=0"), "not_acceptable");
    EXPECT_EQ(chosen(",;,q=,;;"), "not_acceptable");
}

TEST(Formats, TheQueryWinsOverAccept) {
    EXPECT_EQ(chosen("application/json", {{"format", "gltf"}}), "model/gltf+json");
    EXPECT_EQ(chosen("application/json", {{"format", "xdts"}}), "not_a_choice");
    EXPECT_EQ(chosen("application/json", {{"format", ""}}), "not_a_choice");
}

TEST(Formats, TheFrameRateTravelsInHeaderAndFileName) {
    Schedule schedule;
    schedule.fps = {24000, 1001};
    const Response response = formatted(Format::kXdts, "", "sheet", &schedule);
    const NameValues expected{{"Vary", "Accept"},
                              {"Tuftwave-Frame-Rate", "24000/1001"},
                              {"Content-Disposition", "attachment; filename=\"sheet_24000-1001fps.xdts\""}};
    EXPECT_EQ(response.headers, expected);
}

}  // namespace
}  // namespace tuftwave::server
