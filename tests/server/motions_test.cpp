#include "api/motions.hpp"

#include <gtest/gtest.h>

#include "support.hpp"

namespace tuftwave::server {
namespace {

nlohmann::json one_chain() {
    return nlohmann::json::parse(R"({"chains": [{"name": "lock", "nodes": [[0, 1, 0], [0, 0.9, 0], [0, 0.8, 0]]}]})");
}

nlohmann::json answered(const nlohmann::json& body) {
    const Answer answer = answer_to(json_post("/v1/motions", body.dump()));
    const auto* response = std::get_if<Response>(&answer);
    EXPECT_NE(response, nullptr) << slug_of(answer) << " at " << pointer_of(answer);
    return response == nullptr ? nlohmann::json() : nlohmann::json::parse(response->body);
}

TEST(Motions, GiveAPosePerPictureAndNode) {
    const nlohmann::json json = answered(one_chain());
    ASSERT_EQ(json["pictures"].size(), 6U);
    for (const auto& picture : json["pictures"]) {
        EXPECT_EQ(picture["chains"][0]["name"], "lock");
        EXPECT_EQ(picture["chains"][0]["rotations"].size(), 3U);
        // Rest rotations are the identity here, so that the first node is turned by nothing but its own rotation.
        EXPECT_EQ(picture["chains"][0]["turns"].size(), 3U);
        EXPECT_EQ(picture["chains"][0]["turns"][0], picture["chains"][0]["rotations"][0]);
        EXPECT_EQ(picture["chains"][0]["positions"][0], nlohmann::json({0.0, 1.0, 0.0}));
    }
    EXPECT_EQ(json["quality"]["hold_counts"], nlohmann::json({{"1", 1}, {"2", 5}}));
    EXPECT_EQ(json["quality"]["tip_crossings"], 1);
    EXPECT_TRUE(json["warnings"].empty());
}

TEST(Motions, WarnAboutAnUnusualNumberOfPictures) {
    nlohmann::json body = one_chain();
    body["motion"]["timing"] = {{"period", 1}, {"hold", 1}};
    EXPECT_EQ(answered(body)["warnings"][0]["code"], "unusual_picture_count");
}

TEST(Motions, ClipHasOneChannelPerBoneAndATipWithoutOne) {
    const Answer answer = answer_to(json_post("/v1/motions", one_chain().dump(), "model/gltf-binary"));
    const nlohmann::json gltf = glb_json(std::get<Response>(answer).body);
    EXPECT_EQ(gltf["animations"][0]["channels"].size(), 2U);
    EXPECT_EQ(gltf["nodes"].size(), 4U);  // root, two joints, tip
    EXPECT_FALSE(gltf.contains("meshes"));
}

TEST(Motions, AChainsOwnNameIsKeptOnItsFirstJoint) {
    nlohmann::json body = one_chain();
    body["chains"][0]["name"] = "J_Sec_Hair1_01";  // too long for a VMD bone with a number behind it
    const Answer answer = answer_to(json_post("/v1/motions", body.dump(), "model/gltf-binary"));
    const nlohmann::json gltf = glb_json(std::get<Response>(answer).body);
    EXPECT_EQ(gltf["nodes"][1]["name"], "chain_0001_01");
    EXPECT_EQ(gltf["nodes"][1]["extras"]["name"], "J_Sec_Hair1_01");
}

TEST(Motions, OneSidedTakesOutwardFromTheHeadOrFromTheChain) {
    nlohmann::json body = one_chain();
    body["motion"]["one_sided"] = true;
    EXPECT_EQ(pointer_of(answer_to(json_post("/v1/motions", body.dump()))), "/chains/0/outward");
    body["head"]["center"] = {0, 0.9, -0.1};
    EXPECT_EQ(answered(body)["pictures"].size(), 6U);
    body.erase("head");
    body["chains"][0]["outward"] = {0, 0, 1};
    EXPECT_EQ(answered(body)["pictures"].size(), 6U);
}

TEST(Motions, RestRotationsMustMatchTheNodes) {
    nlohmann::json body = one_chain();
    body["chains"][0]["rest_rotations"] = {{0, 0, 0, 1}};
    EXPECT_EQ(pointer_of(answer_to(json_post("/v1/motions", body.dump()))), "/chains/0/rest_rotations");
}

}  // namespace
}  // namespace tuftwave::server
