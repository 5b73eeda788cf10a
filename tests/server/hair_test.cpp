#include "api/hair.hpp"

#include <gtest/gtest.h>

#include "support.hpp"

namespace tuftwave::server {
namespace {

std::string body_of(const Answer& answer) {
    const auto* response = std::get_if<Response>(&answer);
    EXPECT_NE(response, nullptr) << slug_of(answer) << " at " << pointer_of(answer);
    return response == nullptr ? "" : std::string(response->content());
}

std::string posted(const nlohmann::json& body, const std::string& accept = "") {
    return body_of(answer_to(json_post("/v1/hairstyles", body.dump(), accept)));
}

TEST(Hairstyles, AnimatedGlbHasMeshSkinClipAndRecipe) {
    const nlohmann::json gltf = glb_json(posted(small_hairstyle()));
    EXPECT_EQ(gltf["meshes"].size(), 1U);
    EXPECT_EQ(gltf["skins"][0]["joints"].size(), 6U);
    EXPECT_EQ(gltf["animations"][0]["channels"].size(), 6U);
    EXPECT_EQ(gltf["animations"][0]["samplers"][0]["interpolation"], "STEP");
    EXPECT_EQ(gltf["animations"][0]["extras"]["holds"], nlohmann::json({2, 2, 2, 2, 2, 1}));
    EXPECT_EQ(gltf["asset"]["extras"]["tuftwave"]["schedule"]["frames"], 11);
}

TEST(Hairstyles, TheRecipeInTheFileMakesTheSameFileAgain) {
    nlohmann::json body = small_hairstyle();
    body["motion"]["phase"] = {{"seed", 9007199254740991}, {"spread", 0.25}, {"gust_wavelength", 0.4}};
    body["motion"]["timing"]["fps"] = "24000/1001";
    body["tufts"][0]["points"][1][0] = 0.1234567890123456;
    body["mesh"] = {{"rings", 9}, {"layout", "merged"}, {"color", "#A0b1c2"}};
    const std::string first = posted(body);
    EXPECT_EQ(posted(glb_json(first)["asset"]["extras"]["tuftwave"]["hairstyle"]), first);
}

TEST(Hairstyles, WithoutMotionNothingMovesAndThereIsNoSheet) {
    nlohmann::json body = small_hairstyle();
    body.erase("motion");
    EXPECT_FALSE(glb_json(posted(body)).contains("animations"));
    EXPECT_FALSE(nlohmann::json::parse(posted(body, "application/json")).contains("pictures"));
    EXPECT_EQ(pointer_of(answer_to(json_post("/v1/hairstyles", body.dump(), "text/csv"))), "/motion");
    body["motion"] = nullptr;
    EXPECT_FALSE(glb_json(posted(body)).contains("animations"));
}

TEST(Hairstyles, TuftsOfOneShapeShareTheirTriangles) {
    nlohmann::json body = small_hairstyle();
    body["tufts"].push_back(body["tufts"][0]);
    const nlohmann::json gltf = glb_json(posted(body));
    EXPECT_EQ(gltf["meshes"][0]["primitives"][0]["indices"], gltf["meshes"][1]["primitives"][0]["indices"]);
}

TEST(Hairstyles, MergedLayoutIsOneMeshWithOneSkin) {
    nlohmann::json body = small_hairstyle();
    body["tufts"].push_back(body["tufts"][0]);
    body["mesh"]["layout"] = "merged";
    const nlohmann::json gltf = glb_json(posted(body));
    EXPECT_EQ(gltf["meshes"].size(), 1U);
    EXPECT_EQ(gltf["skins"][0]["joints"].size(), 12U);
}

TEST(Hairstyles, WithoutASkinThereAreMeshesAlone) {
    nlohmann::json body = small_hairstyle();
    body.erase("motion");
    body["tufts"].push_back(body["tufts"][0]);
    body["mesh"]["skin"] = false;
    for (const std::string layout : {"per_tuft", "merged"}) {
        body["mesh"]["layout"] = layout;
        const nlohmann::json gltf = glb_json(posted(body));
        const std::size_t meshes = layout == "merged" ? 1 : 2;
        EXPECT_EQ(gltf["meshes"].size(), meshes);
        EXPECT_EQ(gltf["nodes"].size(), meshes);
        EXPECT_FALSE(gltf.contains("skins"));
        EXPECT_EQ(gltf["meshes"][0]["primitives"][0]["attributes"].size(), 3U);
        EXPECT_EQ(gltf["asset"]["extras"]["tuftwave"]["hairstyle"]["mesh"]["skin"], false);
    }
    EXPECT_EQ(nlohmann::json::parse(posted(body, "application/json"))["totals"]["joints"], 0);
    body["motion"] = nlohmann::json::object();
    EXPECT_EQ(pointer_of(answer_to(json_post("/v1/hairstyles", body.dump()))), "/mesh/skin");
}

TEST(Hairstyles, AFlipBookIsAMeshPerPictureWithoutSkins) {
    nlohmann::json body = small_hairstyle();
    body["tufts"].push_back(body["tufts"][0]);
    Request request = json_post("/v1/hairstyles", body.dump());
    request.query = {{"clip", "flip_book"}};
    const nlohmann::json gltf = glb_json(body_of(answer_to(request)));
    EXPECT_EQ(gltf["meshes"].size(), 6U);  // both tufts in each
    EXPECT_FALSE(gltf.contains("skins"));
    EXPECT_EQ(gltf["nodes"].size(), 7U);
    EXPECT_EQ(gltf["nodes"][1]["scale"], nlohmann::json({1.0, 1.0, 1.0}));
    EXPECT_EQ(gltf["nodes"][2]["scale"], nlohmann::json({0.0, 0.0, 0.0}));
    ASSERT_EQ(gltf["animations"][0]["channels"].size(), 6U);
    for (const auto& channel : gltf["animations"][0]["channels"]) EXPECT_EQ(channel["target"]["path"], "scale");
    for (const auto& mesh : gltf["meshes"]) {  // triangles and texture coordinates are shared
        EXPECT_EQ(mesh["primitives"][0]["indices"], gltf["meshes"][0]["primitives"][0]["indices"]);
        EXPECT_FALSE(mesh["primitives"][0]["attributes"].contains("WEIGHTS_0"));
    }
}

TEST(Hairstyles, OptionsOfClipsNeedAClip) {
    nlohmann::json body = small_hairstyle();
    const auto asked = [&](const NameValues& query) {
        Request request = json_post("/v1/hairstyles", body.dump());
        request.query = query;
        return answer_to(request);
    };
    EXPECT_EQ(pointer_of(asked({{"format", "json"}, {"interpolation", "held"}})), "?interpolation");
    EXPECT_EQ(pointer_of(asked({{"format", "bvh"}, {"clip", "flip_book"}})), "?clip");
    EXPECT_EQ(slug_of(asked({{"format", "json"}, {"interpolation", "step"}, {"clip", "skeleton"}})), "no problem");
    body.erase("motion");
    EXPECT_EQ(pointer_of(asked({{"interpolation", "held"}})), "/motion");
    EXPECT_EQ(pointer_of(asked({{"clip", "flip_book"}})), "/motion");
    EXPECT_EQ(slug_of(asked({{"interpolation", "step"}})), "no problem");
}

TEST(Hairstyles, OnlyGlbWithoutAFlipBookIsPacked) {
    for (const std::string path : {"/v1/tufts", "/v1/hairstyles"}) {
        nlohmann::json body = small_hairstyle();
        if (path == "/v1/tufts") body.erase("motion");
        const auto asked = [&](const NameValues& query) {
            Request request = json_post(path, body.dump());
            request.query = query;
            return answer_to(request);
        };
        EXPECT_EQ(glb_json(body_of(asked({{"compression", "meshopt"}})))["buffers"].size(), 2U);
        EXPECT_EQ(body_of(asked({{"compression", "none"}})), body_of(asked({})));
        EXPECT_EQ(pointer_of(asked({{"compression", "meshopt"}, {"format", "gltf"}})), "?compression");
        EXPECT_EQ(pointer_of(asked({{"compression", "draco"}})), "?compression");
        if (path == "/v1/tufts") continue;
        EXPECT_EQ(pointer_of(asked({{"compression", "meshopt"}, {"clip", "flip_book"}})), "?compression");
    }
}

TEST(Hairstyles, ANameThatDoesNotSurviveIsKeptInExtras) {
    nlohmann::json body = small_hairstyle();
    body["tufts"][0]["name"] = "前髪";
    const nlohmann::json gltf = glb_json(posted(body));
    const nlohmann::json& node = gltf["nodes"].back();
    EXPECT_EQ(node["name"], "tuft_0001");
    EXPECT_EQ(node["extras"]["name"], "前髪");
}

TEST(Hairstyles, TheFirstWrongFieldIsNamed) {
    nlohmann::json body = small_hairstyle();
    body["tufts"][0]["points"][2][1] = "up";
    EXPECT_EQ(pointer_of(answer_to(json_post("/v1/hairstyles", body.dump()))), "/tufts/0/points/2/1");
    body = small_hairstyle();
    body["motion"]["wave"]["lightness"] = 0;
    EXPECT_EQ(pointer_of(answer_to(json_post("/v1/hairstyles", body.dump()))), "/motion/wave/lightness");
    body = small_hairstyle();
    body["tufts"][0]["cycles"] = 3;  // of 6 pictures
    EXPECT_EQ(pointer_of(answer_to(json_post("/v1/hairstyles", body.dump()))), "/tufts/0/cycles");
}

TEST(Hairstyles, AreCancelledByTheirStopToken) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(slug_of(answer_to(json_post("/v1/hairstyles", small_hairstyle().dump()), stop.get_token())), "deadline");
}

TEST(Tufts, AreStillAndKnowNoMotion) {
    nlohmann::json body = small_hairstyle();
    EXPECT_EQ(pointer_of(answer_to(json_post("/v1/tufts", body.dump()))), "/motion");
    body.erase("motion");
    EXPECT_EQ(glb_json(body_of(answer_to(json_post("/v1/tufts", body.dump()))))["meshes"].size(), 1U);
}

TEST(Tufts, TheRecipeInTheFileMakesTheSameFileAgain) {
    nlohmann::json body = small_hairstyle();
    body.erase("motion");
    const std::string first = body_of(answer_to(json_post("/v1/tufts", body.dump())));
    const nlohmann::json recipe = glb_json(first)["asset"]["extras"]["tuftwave"]["hairstyle"];
    EXPECT_EQ(body_of(answer_to(json_post("/v1/tufts", recipe.dump()))), first);
}

TEST(Tufts, WantJsonInIdentityEncoding) {
    Request request = json_post("/v1/tufts", "{}");
    request.headers[0].second = "application/x-www-form-urlencoded";
    EXPECT_EQ(slug_of(answer_to(request)), "unsupported_media_type");
    request.headers[0].second = "Application/JSON ; charset=utf-8";
    EXPECT_EQ(slug_of(answer_to(request)), "missing_field");
    request.headers.emplace_back("content-encoding", "gzip");
    EXPECT_EQ(slug_of(answer_to(request)), "unsupported_media_type");
}

}  // namespace
}  // namespace tuftwave::server
