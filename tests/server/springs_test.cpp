#include "character/springs.hpp"

#include "character_samples.hpp"

namespace tuftwave::server::character {
namespace {

/// Removes the springs of the chains of these names.
void remove(Sample& sample, const std::vector<std::string>& names) {
    const FoundChains found = chains_in(sample);
    std::vector<FoundChain> moved;
    for (const std::string& name : names) moved.push_back(chain_named(found, name));
    const Character character = read(sample);
    EXPECT_EQ(count_springs(character, moved), remove_springs(sample.json, character, moved));
}

TEST(Springs, OfMovedChainsGoAndOthersStay) {
    Sample sample;
    sample.add_spring("hair", sample.add_line({"a", "a_end"}));
    sample.add_spring("skirt", sample.add_line({"b", "b_end"}));
    sample.json["extensions"]["VRMC_springBone"]["colliders"] = FileJson::array({1});
    remove(sample, {"a"});
    const FileJson& spring_bone = sample.json["extensions"]["VRMC_springBone"];
    ASSERT_EQ(spring_bone["springs"].size(), 1U);
    EXPECT_EQ(spring_bone["springs"][0]["name"], "skirt");
    remove(sample, {"b"});
    EXPECT_FALSE(sample.json["extensions"]["VRMC_springBone"].contains("springs"));
    EXPECT_TRUE(sample.json["extensions"]["VRMC_springBone"].contains("colliders"));
}

TEST(Springs, ALastJointTurnsNothing) {
    Sample sample;
    const std::vector<int> line = sample.add_line({"a", "b", "c"});
    sample.add_spring("moved", {line[1], line[2]});
    sample.add_spring("ends on it", {line[0], line[1]});
    const FoundChain chain = chain_named(chains_in(sample), "b");
    EXPECT_EQ(count_springs(read(sample), {chain}), 1U);
}

TEST(Springs, ARootTakesAllBelowItAlong) {
    Sample sample;
    const std::vector<int> trunk = sample.add_line({"t1", "t2"});
    sample.add_line({"l1", "l2"}, trunk[1]);
    sample.add_line({"r1", "r2"}, trunk[1]);
    const std::vector<int> other = sample.add_line({"o1", "o2"});
    sample.add_group("hair", {trunk[0], other[0]});
    sample.add_group("none", {});
    remove(sample, {"l1"});
    const FileJson expected = FileJson::parse(R"([{"comment": "hair", "bones": [)" + std::to_string(other[0]) +
                                              R"(]}, {"comment": "none", "bones": []}])");
    EXPECT_EQ(sample.json["extensions"]["VRM"]["secondaryAnimation"]["boneGroups"], expected);
    remove(sample, {"o1"});
    EXPECT_EQ(sample.json["extensions"]["VRM"]["secondaryAnimation"]["boneGroups"].size(), 1U);
}

TEST(Springs, NothingChangesWhereNothingMoves) {
    Sample sample;
    sample.add_spring("hair", sample.add_line({"a", "a_end"}));
    const FileJson before = sample.json;
    remove(sample, {});
    EXPECT_EQ(sample.json, before);
}

}  // namespace
}  // namespace tuftwave::server::character
