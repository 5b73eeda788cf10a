#include "api/problem.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "assets/assets.hpp"

namespace tuftwave::server {
namespace {

nlohmann::json body_of(const Problem& problem) { return nlohmann::json::parse(to_response(problem, "id").body); }

TEST(Problem, EveryCodeHasItsOwnSlugAndAnErrorStatus) {
    std::set<std::string> slugs;
    for (int code = 0; code <= static_cast<int>(ProblemCode::kInternal); ++code) {
        EXPECT_TRUE(slugs.insert(slug(static_cast<ProblemCode>(code))).second) << code;
        EXPECT_GE(status(static_cast<ProblemCode>(code)), 400) << code;
        EXPECT_LE(status(static_cast<ProblemCode>(code)), 599) << code;
    }
}

TEST(Problem, TheContractListsEverySlug) {
    const std::string contract(asset("openapi.yaml").value());
    const std::string list = contract.substr(contract.find("    Slug:\n"));
    std::size_t listed = 0;
    for (std::size_t at = list.find("        - "); at != std::string::npos; at = list.find("        - ", at + 1))
        ++listed;
    EXPECT_EQ(listed, static_cast<std::size_t>(ProblemCode::kInternal) + 1);
    for (int code = 0; code <= static_cast<int>(ProblemCode::kInternal); ++code) {
        EXPECT_NE(list.find(std::string("        - ") + slug(static_cast<ProblemCode>(code)) + "\n"), std::string::npos)
            << code;
    }
}

TEST(Problem, NamesPointerValueAndRange) {
    const Error error{ErrorCode::kOutOfRange, "/period", 99.0, "0.01 to 60", 0.01, 60};
    const nlohmann::json json = body_of(to_problem(error, "/motion/timing"));
    EXPECT_EQ(json["type"], "urn:tuftwave:problem:out_of_range");
    EXPECT_EQ(json["status"], 422);
    EXPECT_EQ(json["request_id"], "id");
    const nlohmann::json& field = json["errors"][0];
    EXPECT_EQ(field["pointer"], "/motion/timing/period");
    EXPECT_EQ(field["value"], 99);
    EXPECT_EQ(field["minimum"], 0.01);
    EXPECT_EQ(field["maximum"], 60);
    EXPECT_EQ(field["detail"], "A value is out of range: 99; allowed is 0.01 to 60.");
}

TEST(Problem, ACancelledComputationIsPastItsDeadline) {
    EXPECT_EQ(to_problem({ErrorCode::kCancelled, "", {}, "", {}, {}}).code, ProblemCode::kDeadline);
}

TEST(Problem, SurvivesHalfACharacter) {
    FieldProblem field{
        ProblemCode::kNotAChoice, "/taper", std::string("\xe5\x89"), "one of sine", {}, {}};  // cut in the middle
    EXPECT_EQ(body_of(fields_problem({field}))["errors"][0]["value"], "\xef\xbf\xbd");
}

TEST(Problem, IsOneObjectWithItsMembersInOrder) {
    EXPECT_EQ(to_response({ProblemCode::kBusy, "", {}, {}}, "id").body,
              R"({"type":"urn:tuftwave:problem:busy","title":"The server is full; try again shortly.","status":503,)"
              R"("detail":"The server is full; try again shortly.","request_id":"id"})");
    for (int code = 0; code <= static_cast<int>(ProblemCode::kInternal); ++code) {
        const auto its = static_cast<ProblemCode>(code);
        const nlohmann::json plain = body_of({its, "", {}, {}}), detailed = body_of({its, "a \"\n", {{}, {}}, {}});
        EXPECT_EQ(plain["title"], plain["detail"]);
        EXPECT_FALSE(plain.contains("errors"));
        EXPECT_EQ(detailed["detail"], "a \"\n");
        EXPECT_EQ(detailed["errors"].size(), 2u);
    }
}

TEST(Problem, CarriesItsHeaders) {
    const Response response = to_response({ProblemCode::kBusy, "", {}, {{"Retry-After", "1"}}}, "id");
    EXPECT_EQ(response.status, 503);
    EXPECT_EQ(response.content_type, "application/problem+json");
    EXPECT_EQ(response.headers.front(), (std::pair<std::string, std::string>("Retry-After", "1")));
}

}  // namespace
}  // namespace tuftwave::server
