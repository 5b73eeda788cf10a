#include "api/evaluations.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support.hpp"

namespace tuftwave::server {
namespace {

/// Two bones in two pictures against a straight line: the second bone of the second picture is off by a right angle.
nlohmann::json small_evaluation() {
    return nlohmann::json::parse(R"({
        "drawn": [{"name": "lock", "pictures": [[[0, 0], [1, 0], [2, 0]], [[0, 0], [1, 0], [1, 1]]]}],
        "lines": [{"pictures": [[[0, 0], [1, 0], [2, 0]], [[0, 0], [1, 0], [2, 0]]]}]
    })");
}

nlohmann::json answered(const nlohmann::json& body) {
    const Answer answer = answer_to(json_post("/v1/evaluations", body.dump()));
    const auto* response = std::get_if<Response>(&answer);
    EXPECT_NE(response, nullptr) << slug_of(answer) << " at " << pointer_of(answer);
    return response == nullptr ? nlohmann::json{} : nlohmann::json::parse(response->body);
}

std::string fault(const nlohmann::json& body) {
    const Answer answer = answer_to(json_post("/v1/evaluations", body.dump()));
    return slug_of(answer) + " " + pointer_of(answer);
}

TEST(Evaluations, MeasureEachPictureAndAll) {
    const nlohmann::json json = answered(small_evaluation());
    EXPECT_NEAR(json["error"]["angle_deg"].get<double>(), 22.5, 1e-12);
    const nlohmann::json& chain = json["chains"][0];
    EXPECT_EQ(chain["name"], "lock");
    EXPECT_EQ(chain["error"]["pictures"][0]["angle_deg"], 0);
    EXPECT_NEAR(chain["error"]["pictures"][1]["angle_deg"].get<double>(), 45, 1e-12);
    EXPECT_NEAR(chain["still"]["angle_deg"].get<double>(), 22.5, 1e-12);
}

TEST(Evaluations, WarnWhereHoldingStillIsNearer) {
    nlohmann::json body = small_evaluation();
    const auto warnings = [&] { return answered(body)["warnings"]; };
    body["lines"][0]["pictures"][0] = {{0, 0}, {0, 1}, {0, 2}};
    ASSERT_EQ(warnings().size(), 1U);
    EXPECT_EQ(warnings()[0]["code"], "no_better_than_still");
    body["lines"] = body["drawn"];
    EXPECT_TRUE(warnings().empty());
}

TEST(Evaluations, TakeTheLengthThatIsGiven) {
    nlohmann::json body = small_evaluation();
    const double percent = answered(body)["error"]["position_percent"];
    body["drawn"][0]["rest_length"] = 4;  // the lines are 2 long
    EXPECT_NEAR(answered(body)["error"]["position_percent"].get<double>(), percent / 2, 1e-12);
}

TEST(Evaluations, CompareToAMotionOfChains) {
    // A wave without amplitude leaves the chain as it is.
    nlohmann::json body = small_evaluation();
    body["lines"] = nullptr;
    body["chains"] = nlohmann::json::parse(R"([{"nodes": [[0, 0, 0], [1, 0, 0], [2, 0, 0]]}])");
    body["motion"] = nlohmann::json::parse(R"({"wave": {"amplitude": 0}, "timing": {"period": 0.125, "hold": 2}})");
    const nlohmann::json json = answered(body), by_lines = answered(small_evaluation());
    EXPECT_NEAR(json["error"]["angle_deg"].get<double>(), by_lines["error"]["angle_deg"].get<double>(), 1e-9);
    EXPECT_EQ(json["warnings"][0]["code"], "unusual_picture_count");
    body["motion"]["timing"]["hold"] = 1;
    EXPECT_EQ(fault(body), "conflict /motion/timing");
    body["motion"]["timing"]["hold"] = 0;
    EXPECT_EQ(fault(body), "out_of_range /motion/timing/hold");
}

TEST(Evaluations, NeedEitherLinesOrChains) {
    nlohmann::json body = small_evaluation();
    body["chains"] = nlohmann::json::array();
    EXPECT_EQ(fault(body), "conflict /lines");
    body.erase("chains");
    body["motion"] = {{"mode", "absolute"}};
    EXPECT_EQ(fault(body), "conflict /motion");
    body.erase("motion");
    body.erase("lines");
    EXPECT_EQ(fault(body), "missing_field /lines");
    EXPECT_EQ(fault(nlohmann::json::array()), "wrong_type ");
}

TEST(Evaluations, NameWhatDoesNotBelongTogether) {
    const auto fault_with = [](const char* pointer, const nlohmann::json& value) {
        nlohmann::json body = small_evaluation();
        body[nlohmann::json::json_pointer(pointer)] = value;
        return fault(body);
    };
    const nlohmann::json line = {{0, 0}, {1, 0}};
    EXPECT_EQ(fault_with("/lines/1", {{"pictures", {line}}}), "conflict /lines");
    EXPECT_EQ(fault_with("/lines/0/pictures", {line, line}), "conflict /lines/0/pictures/0");
    EXPECT_EQ(fault_with("/lines/0/pictures/2", {{0, 0}, {1, 0}, {2, 0}}), "conflict /lines/0/pictures");
    EXPECT_EQ(fault_with("/drawn/0/pictures/1", line), "conflict /drawn/0/pictures/1");
    EXPECT_EQ(fault_with("/drawn/0/rest_length", 0), "out_of_range /drawn/0/rest_length");
    const nlohmann::json spot = {{1, 1}, {1, 1}, {1, 1}};
    EXPECT_EQ(fault_with("/drawn/0/pictures", {spot, spot}), "degenerate /drawn/0/pictures");
}

TEST(Evaluations, AreCancelledByTheirStopToken) {
    std::stop_source stop;
    stop.request_stop();
    nlohmann::json body = small_evaluation();
    body["lines"] = nullptr;
    body["chains"] = nlohmann::json::parse(R"([{"nodes": [[0, 0, 0], [1, 0, 0], [2, 0, 0]]}])");
    EXPECT_EQ(slug_of(answer_to(json_post("/v1/evaluations", body.dump()), stop.get_token())), "deadline");
}

}  // namespace
}  // namespace tuftwave::server
