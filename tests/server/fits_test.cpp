#include "api/fits.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "support.hpp"

namespace tuftwave::server {
namespace {

nlohmann::json example() {
    std::ifstream file(TUFTWAVE_SOURCE_DIR "/api/examples/fits.json");
    return nlohmann::json::parse(file);
}

nlohmann::json answered(const std::string& path, const nlohmann::json& body, std::stop_token stop = {}) {
    const Answer answer = answer_to(json_post(path, body.dump()), std::move(stop));
    const auto* response = std::get_if<Response>(&answer);
    EXPECT_NE(response, nullptr) << slug_of(answer) << " at " << pointer_of(answer);
    return response == nullptr ? nlohmann::json{} : nlohmann::json::parse(response->body);
}

std::string fault(const nlohmann::json& body) {
    const Answer answer = answer_to(json_post("/v1/fits", body.dump()));
    return slug_of(answer) + " " + pointer_of(answer);
}

TEST(Fits, AnswerAWaveForEachDrawing) {
    nlohmann::json body = example();
    body["drawn"].push_back(body["drawn"][0]);
    body["drawn"][1]["name"] = "other";
    const nlohmann::json json = answered("/v1/fits", body);
    ASSERT_EQ(json["fits"].size(), 2U);
    EXPECT_EQ(json["fits"][1]["name"], "other");
    EXPECT_EQ(json["fits"][1]["wave"], json["fits"][0]["wave"]);
    EXPECT_EQ(json["fits"][0]["error"]["pictures"].size(), 6U);
    EXPECT_TRUE(json["fits"][0]["complete"].get<bool>());
    EXPECT_LT(10 * json["error"]["angle_deg"].get<double>(), json["still"]["angle_deg"].get<double>());
}

TEST(Fits, SpeakTheLanguageOfMotions) {
    const nlohmann::json fit = answered("/v1/fits", example())["fits"][0];
    const nlohmann::json chain{{"nodes", fit["nodes"]}, {"phase", fit["phase"]}, {"cycles", fit["cycles"]}};
    const nlohmann::json moved = answered("/v1/motions", {{"chains", {chain}}, {"motion", {{"wave", fit["wave"]}}}});
    EXPECT_EQ(moved["pictures"].size(), 6U);
}

TEST(Fits, EndWithTheBestSoFarWhenTheirStepsAreUsedUp) {
    nlohmann::json body = example();
    body["steps"] = 2;
    const nlohmann::json fit = answered("/v1/fits", body)["fits"][0];
    EXPECT_FALSE(fit["complete"].get<bool>());
    EXPECT_EQ(fit["steps"], 2);
}

TEST(Fits, StopAtOnceWhenTheirAnswerIsThrownAway) {
    std::stop_source stop;
    stop.request_stop();
    const nlohmann::json fit = answered("/v1/fits", example(), stop.get_token())["fits"][0];
    EXPECT_FALSE(fit["complete"].get<bool>());
    EXPECT_EQ(fit["steps"], 0);
}

TEST(Fits, WarnOfWhatCannotBeTold) {
    nlohmann::json body = example();
    while (body["drawn"][0]["pictures"].size() > 2) body["drawn"][0]["pictures"].erase(2);
    EXPECT_EQ(answered("/v1/fits", body)["fits"][0]["warnings"][0]["code"], "two_pictures");
    body["drawn"][0]["pictures"][1] = body["drawn"][0]["pictures"][0];
    EXPECT_EQ(answered("/v1/fits", body)["fits"][0]["warnings"][1]["code"], "nothing_moves");
}

TEST(Fits, NameWhatIsWrong) {
    const auto fault_with = [](const char* pointer, const nlohmann::json& value) {
        nlohmann::json body = example();
        body[nlohmann::json::json_pointer(pointer)] = value;
        return fault(body);
    };
    EXPECT_EQ(fault_with("/timing", {{"period", 0.45}}), "no problem no field");
    EXPECT_EQ(fault_with("/timing", {{"period", 0.3}}), "conflict /drawn/0/pictures");
    EXPECT_EQ(fault_with("/timing", {{"period", 0}}), "out_of_range /timing/period");
    EXPECT_EQ(fault_with("/cycles", 3), "conflict /cycles");
    EXPECT_EQ(fault_with("/steps", 1001), "out_of_range /steps");
    EXPECT_EQ(fault_with("/wind", {0, 1, 0}), "degenerate /wind");
    EXPECT_EQ(fault_with("/drawn/0/rest", nullptr), "no problem no field");
    EXPECT_EQ(fault_with("/drawn/0/rest/0", {2e6, 0}), "out_of_range /drawn/0/rest/0/0");
    EXPECT_EQ(fault_with("/mode", "both"), "not_a_choice /mode");
}

}  // namespace
}  // namespace tuftwave::server
