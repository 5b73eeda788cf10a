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
    const nlohmann::json gltf = glb_json(std::string(std::get<Response>(answer).content()));
    EXPECT_EQ(gltf["animations"][0]["channels"].size(), 2U);
    EXPECT_EQ(gltf["nodes"].size(), 4U);  // root, two joints, tip
    EXPECT_FALSE(gltf.contains("meshes"));
}

TEST(Motions, AChainsOwnNameIsKeptOnItsFirstJoint) {
    nlohmann::json body = one_chain();
    body["chains"][0]["name"] = "J_Sec_Hair1_01";  // too long for a VMD bone with a number behind it
    const Answer answer = answer_to(json_post("/v1/motions", body.dump(), "model/gltf-binary"));
    const nlohmann::json gltf = glb_json(std::string(std::get<Response>(answer).content()));
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

Answer posted_with(const NameValues& query, const nlohmann::json& body = one_chain()) {
    Request request = json_post("/v1/motions", body.dump());
    request.query = query;
    return answer_to(request);
}

std::string header_of(const Answer& answer, const std::string& name) {
    for (const auto& [key, value] : std::get<Response>(answer).headers) {
        if (key == name) return value;
    }
    return "";
}

TEST(Motions, AVmdHasThirtyFramesPerSecondWhateverIsAskedFor) {
    nlohmann::json body = one_chain();
    std::vector<std::string> files;
    for (const nlohmann::json& fps : {nlohmann::json(24), nlohmann::json(30), nlohmann::json("60000/1001")}) {
        body["motion"]["timing"]["fps"] = fps;
        const Answer answer = posted_with({{"format", "vmd"}}, body);
        EXPECT_EQ(header_of(answer, "Tuftwave-Frame-Rate"), "30");
        EXPECT_EQ(header_of(answer, "Content-Disposition"), "attachment; filename=\"motion_30fps.vmd\"");
        files.emplace_back(std::get<Response>(answer).content());
    }
    EXPECT_EQ(files[1], files[0]);
    EXPECT_EQ(files[2], files[0]);
    EXPECT_EQ(files[0].size(), 74 + 111 * 2 * 15U);  // 7 pictures on twos
}

TEST(Motions, AVmdSaysThatItsRateMakesTooManyPictures) {
    nlohmann::json body = one_chain();
    body["motion"]["timing"] = {{"period", 1}, {"fps", 24}, {"hold", 1}};
    const Answer answer = posted_with({{"format", "vmd"}}, body);
    EXPECT_EQ(pointer_of(answer), "/motion/timing/period");
    EXPECT_TRUE(std::get<Problem>(answer).fields[0].allowed.ends_with("30; a VMD has 30 frames per second"));
    body["motion"]["timing"] = {{"fps", 1000}};
    EXPECT_EQ(pointer_of(posted_with({{"format", "vmd"}}, body)), "/motion/timing/fps");
}

TEST(Motions, AVmdRepeatsItsCycle) {
    const std::string twice = std::get<Response>(posted_with({{"format", "vmd"}, {"repeat", "2"}})).body;
    EXPECT_EQ(twice.size(), 74 + 111 * 2 * 29U);
    EXPECT_EQ(pointer_of(posted_with({{"format", "vmd"}, {"repeat", "1440"}})), "?repeat");  // of 14,400 frames
    EXPECT_EQ(slug_of(posted_with({{"format", "bvh"}, {"repeat", "2"}})), "conflict");
    EXPECT_EQ(slug_of(posted_with({{"format", "bvh"}, {"repeat", "1"}})), "no problem");
    EXPECT_EQ(pointer_of(posted_with({{"format", "csv"}, {"repeat", "two"}})), "?repeat");
}

TEST(Motions, AFileHasNoMoreKeysThanTheLimit) {
    nlohmann::json body;
    std::vector<nlohmann::json> nodes;
    for (int i = 0; i < 65; ++i) nodes.push_back({0, -0.01 * i, 0});
    body["chains"] = std::vector<nlohmann::json>(30, {{"nodes", nodes}});     // 1,920 joints
    body["motion"]["timing"] = {{"period", 60}, {"fps", 9.6}, {"hold", 24}};  // 576 frames, 24 pictures
    EXPECT_EQ(slug_of(posted_with({{"format", "bvh"}}, body)), "too_many");
    EXPECT_EQ(pointer_of(posted_with({{"format", "bvh"}}, body)), "/chains");
    EXPECT_EQ(slug_of(posted_with({{"format", "usda"}}, body)), "no problem");
}

TEST(Motions, RestRotationsMustMatchTheNodes) {
    nlohmann::json body = one_chain();
    body["chains"][0]["rest_rotations"] = {{0, 0, 0, 1}};
    EXPECT_EQ(pointer_of(answer_to(json_post("/v1/motions", body.dump()))), "/chains/0/rest_rotations");
}

}  // namespace
}  // namespace tuftwave::server
