#include "api/fills.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support.hpp"
#include "tuftwave/math.hpp"

namespace tuftwave::server {
namespace {

/// A fill around the back of a head, up to the crown and down to the neck: the smallest that has tufts of every kind.
nlohmann::json small_fill() {
    return nlohmann::json::parse(R"({
        "fill": {
            "from": {"points": [[0.1, 0, 0], [0.1, -0.1, 0]]},
            "to": {"points": [[-0.1, 0, 0], [-0.1, -0.1, 0]]},
            "density": {"along": 20, "crown": 20, "neck": 50}
        }
    })");
}

/// Two faces behind the head that meet above the middle of its back.
nlohmann::json small_scalp() {
    return {{"mesh",
             {{"positions", {0.3, -0.3, 0.1, -0.3, -0.3, 0.1, 0, 0.3, -0.1, 0, -0.3, -0.3}},
              {"triangles", {0, 3, 2, 3, 1, 2}}}}};
}

Response answered(const nlohmann::json& body, const std::string& accept = "") {
    const Answer answer = answer_to(json_post("/v1/fills", body.dump(), accept));
    const auto* response = std::get_if<Response>(&answer);
    EXPECT_NE(response, nullptr) << slug_of(answer) << " at " << pointer_of(answer);
    return response == nullptr ? Response{} : *response;
}

nlohmann::json answered_json(const nlohmann::json& body) { return nlohmann::json::parse(answered(body).body); }

std::string fault(const nlohmann::json& body, const std::string& accept = "") {
    const Answer answer = answer_to(json_post("/v1/fills", body.dump(), accept));
    return slug_of(answer) + " " + pointer_of(answer);
}

TEST(Fills, AnswerWithTuftsAlongThenUpThenDownAndWithAReport) {
    const nlohmann::json json = answered_json(small_fill());
    std::string kinds;
    for (const auto& tuft : json["tufts"]) kinds += tuft["origin"]["kind"].get<std::string>().front();
    EXPECT_EQ(kinds, "aaacccccnnnnn");
    EXPECT_EQ(json["tufts"][0]["name"], "fill_1");
    EXPECT_FALSE(json["tufts"][0]["origin"].contains("parent"));
    EXPECT_EQ(json["tufts"][12]["origin"], nlohmann::json({{"kind", "neck"}, {"index", 1}, {"parent", 5}}));
    EXPECT_EQ(json["report"]["tufts"], nlohmann::json({{"along", 3}, {"crown", 5}, {"neck", 5}}));
    EXPECT_NEAR(json["report"]["sweep"].get<double>(), kPi, 1e-12);
    EXPECT_NEAR(json["report"]["distance"].get<double>(), 0.1 * kPi, 1e-12);
    EXPECT_TRUE(json["warnings"].empty());
}

TEST(Fills, ComeAsJsonGlbOrGltf) {
    EXPECT_EQ(answered(small_fill()).content_type, "application/json");
    EXPECT_EQ(answered(small_fill(), "model/gltf+json").content_type, "model/gltf+json");
    const Response glb = answered(small_fill(), "model/gltf-binary");
    EXPECT_EQ(glb.content_type, "model/gltf-binary");
    EXPECT_EQ(glb.headers.back().second, "attachment; filename=\"fill.glb\"");
    EXPECT_EQ(glb_json(std::string(glb.content()))["meshes"].size(), 13U);
    EXPECT_FALSE(glb_json(std::string(glb.content())).contains("animations"));
    EXPECT_EQ(fault(small_fill(), "text/csv"), "not_acceptable no field");
    Request request = json_post("/v1/fills", small_fill().dump());
    request.query = {{"format", "xdts"}};
    EXPECT_EQ(pointer_of(answer_to(request)), "?format");
}

TEST(Fills, AFileHoldsTheTuftsAsARecipe) {
    const nlohmann::json recipe = glb_json(
        std::string(answered(small_fill(), "model/gltf-binary").content()))["asset"]["extras"]["tuftwave"]["hairstyle"];
    EXPECT_EQ(recipe["tufts"], answered_json(small_fill())["tufts"]);
    EXPECT_FALSE(recipe.contains("fills"));
}

TEST(Fills, ARingHasNoSecondTuft) {
    nlohmann::json body = small_fill();
    body["fill"].erase("to");
    const std::string absent = answered(body).body;
    body["fill"]["to"] = nullptr;
    EXPECT_EQ(answered(body).body, absent);
    EXPECT_NEAR(nlohmann::json::parse(absent)["report"]["sweep"].get<double>(), 2 * kPi, 1e-12);
}

TEST(Fills, AnEmptyOneWarnsAndGivesNoMesh) {
    nlohmann::json body = small_fill();
    body["fill"]["density"] = {{"along", 0}};
    const nlohmann::json json = answered_json(body);
    EXPECT_EQ(json["tufts"], nlohmann::json::array());
    EXPECT_EQ(json["warnings"][0]["code"], "empty_fill");
    EXPECT_EQ(fault(body, "model/gltf-binary"), "too_few /fill/density");
}

TEST(Fills, TheWrongFieldIsNamed) {
    const auto fault_with = [](const char* pointer, const nlohmann::json& value) {
        nlohmann::json body = small_fill();
        body[nlohmann::json::json_pointer(pointer)] = value;
        return fault(body);
    };
    EXPECT_EQ(fault({{"head", nlohmann::json::object()}}), "missing_field /fill");
    EXPECT_EQ(fault_with("/fill/from", nullptr), "wrong_type /fill/from");
    EXPECT_EQ(fault_with("/fill/to/points/1/0", "left"), "wrong_type /fill/to/points/1/0");
    EXPECT_EQ(fault_with("/fill/to/diameter", 0), "out_of_range /fill/to/diameter");
    EXPECT_EQ(fault_with("/fill/density/neck", 0.5), "out_of_range /fill/density/neck");
    EXPECT_EQ(fault_with("/fill/jitter", {{"sed", 1}}), "unknown_field /fill/jitter/sed");
    EXPECT_EQ(fault_with("/fill/name", std::string(49, 'x')), "too_many /fill/name");
    EXPECT_EQ(fault_with("/fill/tufts_per_meter", 1e6), "too_many /fill/density/along");
    EXPECT_EQ(fault_with("/head/scalp", nlohmann::json::object()), "missing_field /head/scalp");
    EXPECT_EQ(fault_with("/head/scalp", {{"ellipsoid", {{"radii", {1, 1, 0}}}}}),
              "out_of_range /head/scalp/ellipsoid/radii/2");
    EXPECT_EQ(fault_with("/head/scalp", {{"ellipsoid", {{"radii", {1, 1, 1}}, {"center", {0, 1, 0}}}}}),
              "degenerate /head/scalp/ellipsoid");
    EXPECT_EQ(fault_with("/fills", nlohmann::json::array()), "unknown_field /fills");
}

TEST(Fills, UnequalStrokesAreNotResampledAgainstTheCallersWill) {
    nlohmann::json body = small_fill();
    body["fill"]["from"]["points"].push_back({0.1, -0.2, 0});
    EXPECT_EQ(answered_json(body)["report"]["resampled"], nlohmann::json({"from", "to"}));
    body["fill"]["resample"] = false;
    EXPECT_EQ(fault(body), "conflict /fill/to/points");
    body["fill"]["resample"] = nullptr;
    body["fill"]["formulas"] = "as_printed";
    EXPECT_EQ(fault(body), "undefined_as_printed /fill/to/points");
}

TEST(Fills, CountWhatAScalpMeshDoesNotCover) {
    nlohmann::json body = small_fill();
    body["head"]["scalp"] = small_scalp();
    const nlohmann::json report = answered_json(body)["report"];
    EXPECT_GT(report["removed"]["off_scalp"], 0);
    EXPECT_EQ(report["tufts"]["along"], 3);  // behind the head; the two beside it are copied to where there is none
    std::size_t counted = 0;
    for (const char* const part : {"tufts", "removed"}) {
        for (const auto& count : report[part]) counted += count.get<std::size_t>();
    }
    EXPECT_EQ(counted, 13U);
}

TEST(Fills, AreCancelledByTheirStopToken) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(slug_of(answer_to(json_post("/v1/fills", small_fill().dump()), stop.get_token())), "deadline");
}

/// The small fill between two named tufts of a hairstyle, on a scalp mesh.
nlohmann::json filled_hairstyle() {
    nlohmann::json from = small_fill()["fill"]["from"], to = small_fill()["fill"]["to"];
    from["name"] = "left";
    to["name"] = "right";
    return {{"head", {{"scalp", small_scalp()}}},
            {"tufts", {from, to}},
            {"fills", {{{"from", "left"}, {"to", "right"}, {"density", {{"neck", 50}}}, {"jitter", {{"seed", 5}}}}}},
            {"motion", nlohmann::json::object()}};
}

TEST(FilledHairstyles, TheRecipeKeepsScalpAndFillsAndMakesTheSameFileAgain) {
    const auto posted = [](const nlohmann::json& body) {
        const Answer answer = answer_to(json_post("/v1/hairstyles", body.dump()));
        const auto* response = std::get_if<Response>(&answer);
        EXPECT_NE(response, nullptr) << slug_of(answer) << " at " << pointer_of(answer);
        return response == nullptr ? "" : std::string(response->content());
    };
    const std::string first = posted(filled_hairstyle());
    const nlohmann::json recipe = glb_json(first)["asset"]["extras"]["tuftwave"]["hairstyle"];
    EXPECT_EQ(recipe["head"]["scalp"], small_scalp());
    EXPECT_EQ(recipe["tufts"].size(), 2U);
    EXPECT_EQ(recipe["fills"][0]["name"], "fill1");
    EXPECT_EQ(recipe["fills"][0]["jitter"], nlohmann::json({{"seed", 5}}));
    EXPECT_EQ(posted(recipe), first);
}

TEST(FilledHairstyles, AFillNamesItsTufts) {
    const auto fault_with = [](const char* pointer, const nlohmann::json& value) {
        nlohmann::json body = filled_hairstyle();
        body[nlohmann::json::json_pointer(pointer)] = value;
        const Answer answer = answer_to(json_post("/v1/hairstyles", body.dump()));
        return slug_of(answer) + " " + pointer_of(answer);
    };
    EXPECT_EQ(fault_with("/fills/0/from", "nobody"), "not_a_choice /fills/0/from");
    EXPECT_EQ(fault_with("/tufts/1/name", "left"), "conflict /fills/0/from");
    EXPECT_EQ(fault_with("/fills/0/density/neck", 101), "out_of_range /fills/0/density/neck");
    EXPECT_EQ(fault_with("/tufts/1/diameter", 101), "out_of_range /tufts/1/diameter");
    EXPECT_EQ(fault_with("/fills/0/to", "left"), "no problem no field");  // a ring
    EXPECT_EQ(fault_with("/fills/0/to", nullptr), "no problem no field");
}

TEST(FilledHairstyles, AreCancelledByTheirStopToken) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(slug_of(answer_to(json_post("/v1/hairstyles", filled_hairstyle().dump()), stop.get_token())), "deadline");
}

}  // namespace
}  // namespace tuftwave::server
