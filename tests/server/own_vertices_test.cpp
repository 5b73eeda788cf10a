#include "character/own_vertices.hpp"

#include <gtest/gtest.h>

#include "character_samples.hpp"

namespace tuftwave::server::character {
namespace {

void expect_near(const Vec3& a, const Vec3& b) {
    EXPECT_LT(length(a - b), 1e-6) << a.x << " " << a.y << " " << a.z << ", not " << b.x << " " << b.y << " " << b.z;
}

/// A joint at (0, -0.1, 0), one below it at (0, -0.2, 0), and their skin.
Sample two_joints() {
    Sample sample;
    sample.add_skin(sample.add_line({"a", "b"}));
    return sample;
}

std::vector<OwnVertices> found_in(const Sample& sample) { return own_vertices(sample, read(sample)); }

Fault fault_in(const Sample& sample, std::size_t most = 1'000) {
    const auto found = find_own_vertices(sample.json, sample.binary, read(sample), most);
    if (const auto* fault = std::get_if<Fault>(&found)) return *fault;
    return {Fault::Kind::kMalformed, "no fault", {}, {}, {}, {}};
}

TEST(OwnVertices, HaveAMiddleAndAReach) {
    Sample sample = two_joints();
    sample.add_vertices(0, 1, {{0.1, 0, 0}, {0, -0.3, 0}});
    const std::vector<OwnVertices> own = found_in(sample);
    ASSERT_EQ(own.size(), 3U);
    EXPECT_EQ(own[0].count, 0U);
    ASSERT_EQ(own[1].count, 2U);
    expect_near(own[1].middle, {0.05, -0.35, 0});
    EXPECT_NEAR(own[1].reach, 0.3, 1e-6);
}

TEST(OwnVertices, FollowOneJointMoreThanAllOthers) {
    Sample sample = two_joints();
    sample.add_vertices(0, 1, {{0.1, 0, 0}, {0, -0.3, 0}});
    sample.add("accessors", sample.json["accessors"][2]);
    const std::string weights = bytes_of<float>({0.5F, 0.5F, 0, 0, 0.25F, 0.75F, 0, 0});
    sample.binary.replace(sample.json["bufferViews"][2]["byteOffset"].get<std::size_t>(), weights.size(), weights);
    const std::vector<OwnVertices> own = found_in(sample);
    EXPECT_EQ(own[1].count, 0U) << "half and half is nobody's";
    ASSERT_EQ(own[0].count, 1U) << "slot 0 is the first joint";
    expect_near(own[0].middle, {0, -0.4, 0});
}

TEST(OwnVertices, StandWhereTheBindMatrixPutsThem) {
    Sample sample = two_joints();
    std::vector<float> matrices(32, 0);
    for (std::size_t joint = 0; joint < 2; ++joint) {
        for (std::size_t i = 0; i < 4; ++i) matrices[16 * joint + 5 * i] = 1;
        matrices[16 * joint + 13] = 0.1F * static_cast<float>(joint + 1);  // back by the joint's place
    }
    sample.json["skins"][0]["inverseBindMatrices"] = sample.add_accessor(bytes_of(matrices), kFloat, "MAT4", 2);
    sample.add_vertices(0, 1, {{0, -0.25, 0}});
    expect_near(found_in(sample)[1].middle, {0, -0.25, 0});
    EXPECT_NEAR(found_in(sample)[1].reach, 0.05, 1e-6);
}

TEST(OwnVertices, OfSharedAccessorsCountOnce) {
    Sample sample = two_joints();
    const std::size_t mesh = sample.add_vertices(0, 1, {{0.1, 0, 0}});
    FileJson& primitives = sample.json["meshes"][mesh]["primitives"];
    primitives.push_back(FileJson(primitives[0]));
    EXPECT_EQ(found_in(sample)[1].count, 1U);
}

TEST(OwnVertices, OfUnskinnedMeshesAndForeignJointsAreNobodys) {
    Sample sample = two_joints();
    sample.add_vertices(0, 2, {{0.1, 0, 0}});
    EXPECT_EQ(found_in(sample)[0].count + found_in(sample)[1].count, 0U) << "the skin has no third joint";
    Sample bare = two_joints();
    bare.add_vertices(0, 1, {{0.1, 0, 0}});
    bare.node(2).erase("skin");
    EXPECT_EQ(found_in(bare)[1].count, 0U);
}

TEST(OwnVertices, OfJointsBelowNoneAreNobodys) {
    Sample sample = two_joints();
    sample.add_vertices(0, 0xBD, {{0.1, 0, 0}});
    sample.json["accessors"][1]["componentType"] = kByte;
    EXPECT_EQ(found_in(sample)[0].count + found_in(sample)[1].count, 0U) << "the slot is -67";
}

TEST(OwnVertices, ThatAreNoNumbersAreLeftOut) {
    Sample sample = two_joints();
    const float odd = std::numeric_limits<float>::quiet_NaN(), far = std::numeric_limits<float>::infinity();
    sample.add_vertices(0, 1, {{odd, 0, 0}, {0, far, 0}, {0, -0.3, 0}});
    const OwnVertices own = found_in(sample)[1];
    EXPECT_EQ(own.count, 1U);
    expect_near(own.middle, {0, -0.5, 0});
}

TEST(OwnVertices, AreLimitedInAll) {
    Sample sample = two_joints();
    sample.add_vertices(0, 0, {{0, 0, 0}, {0.1, 0, 0}});
    sample.add_vertices(0, 1, {{0, 0, 0}, {0.1, 0, 0}});
    EXPECT_EQ(fault_in(sample, 4).pointer, "no fault");
    EXPECT_EQ(fault_in(sample, 3).kind, Fault::Kind::kTooMany);
    EXPECT_EQ(fault_in(sample, 3).pointer, "/meshes/1");
}

TEST(OwnVertices, OutsideTheFileAreAFault) {
    Sample sample = two_joints();
    sample.add_vertices(0, 1, {{0.1, 0, 0}});
    sample.json["accessors"][0]["count"] = 2;
    EXPECT_EQ(fault_in(sample).kind, Fault::Kind::kOutOfRange);
    EXPECT_EQ(fault_in(sample).pointer, "/accessors/0");
    sample.json["accessors"][0]["count"] = 1;
    sample.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = 99;
    EXPECT_EQ(fault_in(sample).pointer, "/meshes/0/primitives/0/attributes/JOINTS_0");
    sample.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = 1;
    sample.node(2)["skin"] = 1;
    EXPECT_EQ(fault_in(sample).pointer, "/nodes/2/skin");
}

TEST(OwnVertices, WithFewerWeightsThanPlacesArePassedOver) {
    Sample sample = two_joints();
    sample.add_vertices(0, 1, {{0.1, 0, 0}, {0.2, 0, 0}});
    sample.json["accessors"][2]["count"] = 1;
    EXPECT_EQ(found_in(sample)[1].count, 0U);
}

TEST(OwnVertices, OfASkinWhoseDataLiesElsewhereArePassedOver) {
    Sample sample = two_joints();
    sample.add_vertices(0, 1, {{0.1, 0, 0}});
    sample.json["bufferViews"][0]["buffer"] = 1;
    EXPECT_EQ(found_in(sample)[1].count, 0U);
}

}  // namespace
}  // namespace tuftwave::server::character
