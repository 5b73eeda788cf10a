#include <gtest/gtest.h>

#include "character/character.hpp"
#include "character_samples.hpp"

namespace tuftwave::server::character {
namespace {

Sample three_nodes() {
    Sample sample;
    sample.add_line({"hips", "head", "hair"});
    return sample;
}

TEST(CharacterVrm, OfVersion1NamesBonesAndSprings) {
    Sample sample = three_nodes();
    sample.set_bone("hips", 0);
    sample.set_bone("head", 1);
    sample.add_spring("fringe", {1, 2});
    const Character character = read(sample);
    EXPECT_EQ(character.humanoid, (std::map<std::string, int>{{"head", 1}, {"hips", 0}}));
    ASSERT_EQ(character.springs.size(), 1U);
    EXPECT_EQ(character.springs[0].name, "fringe");
    EXPECT_EQ(character.springs[0].joints, (std::vector<int>{1, 2}));
    EXPECT_FALSE(character.faces_minus_z);
}

TEST(CharacterVrm, OfVersion0NamesBonesAndGroupsAndFacesTheOtherWay) {
    Sample sample = three_nodes();
    sample.json["extensions"]["VRM"]["humanoid"]["humanBones"] =
        FileJson::parse(R"([{"bone": "hips", "node": 0}, {"bone": "head", "node": 1}])");
    sample.add_group("hair", {2});
    sample.json["extensions"]["VRM"]["secondaryAnimation"]["boneGroups"].push_back(FileJson::object());
    const Character character = read(sample);
    EXPECT_EQ(character.humanoid, (std::map<std::string, int>{{"head", 1}, {"hips", 0}}));
    ASSERT_EQ(character.bone_groups.size(), 2U);
    EXPECT_EQ(character.bone_groups[0].name, "hair");
    EXPECT_EQ(character.bone_groups[0].roots, std::vector<int>{2});
    EXPECT_TRUE(character.bone_groups[1].roots.empty());
    EXPECT_TRUE(character.faces_minus_z);
}

TEST(CharacterVrm, OfBothVersionsIsReadAsTheNewer) {
    Sample sample = three_nodes();
    sample.set_bone("head", 1);
    sample.add_group("hair", {2});
    const Character character = read(sample);
    EXPECT_TRUE(character.bone_groups.empty());
    EXPECT_FALSE(character.faces_minus_z);
}

TEST(CharacterVrm, SaysWhatIsWrongAndWhere) {
    using Kind = Fault::Kind;
    const struct {
        const char* extensions;
        Kind kind;
        const char* pointer;
    } rows[] = {
        {R"([])", Kind::kWrongType, "/extensions"},
        {R"({"VRMC_vrm": {"humanoid": {"humanBones": {"head": {"node": 3}}}}})", Kind::kOutOfRange,
         "/extensions/VRMC_vrm/humanoid/humanBones/head/node"},
        {R"({"VRMC_vrm": {"humanoid": {"humanBones": {"a/~b": 0}}}})", Kind::kWrongType,
         "/extensions/VRMC_vrm/humanoid/humanBones/a~1~0b"},
        {R"({"VRMC_springBone": {"springs": [{"joints": [{"node": 0}, {"node": -1}]}]}})", Kind::kOutOfRange,
         "/extensions/VRMC_springBone/springs/0/joints/1/node"},
        {R"({"VRMC_springBone": {"springs": {}}})", Kind::kWrongType, "/extensions/VRMC_springBone/springs"},
        {R"({"VRM": {"humanoid": {"humanBones": {}}}})", Kind::kWrongType, "/extensions/VRM/humanoid/humanBones"},
        {R"({"VRM": {"humanoid": {"humanBones": [{"bone": "head", "node": 9}]}}})", Kind::kOutOfRange,
         "/extensions/VRM/humanoid/humanBones/0/node"},
        {R"({"VRM": {"secondaryAnimation": {"boneGroups": [{"bones": [0, 3]}]}}})", Kind::kOutOfRange,
         "/extensions/VRM/secondaryAnimation/boneGroups/0/bones/1"},
    };
    for (const auto& row : rows) {
        Sample sample = three_nodes();
        sample.json["extensions"] = FileJson::parse(row.extensions);
        const Fault fault = read_fault(sample.json);
        EXPECT_EQ(fault.kind, row.kind) << row.extensions;
        EXPECT_EQ(fault.pointer, row.pointer) << row.extensions;
    }
}

}  // namespace
}  // namespace tuftwave::server::character
