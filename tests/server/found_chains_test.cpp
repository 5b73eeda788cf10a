#include "character/found_chains.hpp"

#include "character_samples.hpp"

namespace tuftwave::server::character {
namespace {

std::vector<int> all_of(const std::vector<int>& a, const std::vector<int>& b) {
    std::vector<int> joined = a;
    joined.insert(joined.end(), b.begin(), b.end());
    return joined;
}

/// Hips and a head, with a lock of three nodes on it; all are joints of one skin.
struct Person : Sample {
    int hips = add_node("hips", -1, {0, 1, 0}), head = add_node("head", hips, {0, 0.5, 0});
    std::vector<int> lock = add_line({"lock1", "lock2", "lock3"}, head);

    void finish(const std::vector<int>& more = {}) { add_skin(all_of(all_of({hips, head}, lock), more)); }
};

TEST(FoundChains, ARunOfJointsBelowTheHeadIsHair) {
    Person person;
    person.finish();
    const FoundChains found = chains_in(person);
    ASSERT_EQ(found.chains.size(), 1U);
    const FoundChain& chain = found.chains.front();
    EXPECT_EQ(found.head, person.head);
    EXPECT_EQ(chain.bones, (std::vector<int>{person.lock[0], person.lock[1]}));
    EXPECT_EQ(chain.tip_node, person.lock[2]);
    EXPECT_EQ(chain.kind, Kind::kHair);
    EXPECT_EQ(chain.found_by, FoundBy::kSkin);
    EXPECT_EQ(chain.because, (std::vector<std::string_view>{"skin_joints", "below_head"}));
}

TEST(FoundChains, VerticesBehindTheLastJointMakeItABoneWhoseTipIsNoNode) {
    Person person;
    person.finish();
    person.add_vertices(0, 4, {{0, 0, 0}, {0, -0.2, 0}, {0, -0.1, 0}});  // slot 4 is lock3
    const FoundChain chain = chain_named(chains_in(person), "lock1");
    EXPECT_EQ(chain.bones, person.lock);
    EXPECT_FALSE(chain.tip_node);
    EXPECT_NEAR(chain.tip.y, 1.5 - 0.3 - 0.2, 1e-6);  // floats
}

TEST(FoundChains, VerticesAroundTheLastJointMakeNoBone) {
    Person person;
    person.finish();
    person.add_vertices(0, 4, {{0, -0.004, 0}});  // 4 % of the last bone
    EXPECT_EQ(chain_named(chains_in(person), "lock1").tip_node, person.lock[2]);
}

TEST(FoundChains, OneJointWithVerticesIsAChainAndOneWithoutIsNone) {
    Person person;
    const int lonely = person.add_node("lonely", person.head), bare = person.add_node("bare", person.head);
    person.finish({lonely, bare});
    person.add_vertices(0, 5, {{0.1, -0.1, 0}});
    const FoundChains found = chains_in(person);
    EXPECT_EQ(chain_named(found, "lonely").bones, std::vector<int>{lonely});
    EXPECT_EQ(reason_of(found, bare), "no_length");
}

TEST(FoundChains, NodesInOnePlaceAreNoChain) {
    Person person;
    const int first = person.add_node("first", person.head);
    const int second = person.add_node("second", first, {0, 0, 0}), third = person.add_node("third", second, {0, 0, 0});
    person.finish({first, second, third});
    EXPECT_EQ(reason_of(chains_in(person), first), "no_length");
}

TEST(FoundChains, BranchesAreChainsOfTheirOwn) {
    Person person;
    const std::vector<int> left = person.add_line({"left1", "left2"}, person.lock[2]),
                           right = person.add_line({"right1", "right2"}, person.lock[2]);
    person.finish(all_of(left, right));
    const FoundChains found = chains_in(person);
    ASSERT_EQ(found.chains.size(), 3U);
    EXPECT_EQ(found.chains[0].tip_node, person.lock[2]);
    EXPECT_EQ(found.chains[1].name, "left1");
    EXPECT_EQ(found.chains[1].branches_from, 0U);
    EXPECT_EQ(found.chains[2].name, "right1");
    EXPECT_EQ(found.chains[2].branches_from, 0U);
    EXPECT_EQ(found.branchings, std::vector<int>{person.lock[2]});
}

TEST(FoundChains, ARootThatBranchesAtOnceIsNoBone) {
    Person person;
    const int root = person.add_node("root", person.head);
    const std::vector<int> left = person.add_line({"left1", "left2"}, root),
                           right = person.add_line({"right1", "right2"}, root);
    person.finish(all_of({root}, all_of(left, right)));
    const FoundChains found = chains_in(person);
    EXPECT_EQ(found.chains.size(), 3U);
    EXPECT_EQ(reason_of(found, root), "");
    EXPECT_FALSE(chain_named(found, "left1").branches_from);
    EXPECT_EQ(found.branchings, std::vector<int>{root});
}

TEST(FoundChains, ASpringNamesItsJointsAndPassesOverNodesBetween) {
    Sample sample;
    const std::vector<int> line = sample.add_line({"a", "between", "b", "c"});
    sample.add_spring("front", {line[0], line[2], line[3]});
    const FoundChains found = chains_in(sample);
    ASSERT_EQ(found.chains.size(), 1U);
    EXPECT_EQ(found.chains[0].bones, (std::vector<int>{line[0], line[2]}));
    EXPECT_EQ(found.chains[0].tip_node, line[3]);
    EXPECT_EQ(found.chains[0].found_by, FoundBy::kVrm1Spring);
    EXPECT_EQ(found.chains[0].source, 0U);
}

TEST(FoundChains, SpringsThatVrmForbidsAreSkipped) {
    Sample sample;
    const std::vector<int> line = sample.add_line({"a", "b"}), other = sample.add_line({"c", "d"}),
                           backward = sample.add_line({"e", "f"});
    sample.add_spring("first", line);
    sample.add_spring("again", {other[0], line[1]});
    sample.add_spring("backward", {backward[1], backward[0]});
    sample.add_spring("single", {other[1]});
    const FoundChains found = chains_in(sample);
    EXPECT_EQ(found.chains.size(), 1U);
    EXPECT_EQ(reason_of(found, backward[1]), "broken_spring");
    EXPECT_EQ(reason_of(found, other[1]), "no_length");
    EXPECT_NE(reason_of(found, other[0]), "");
}

TEST(FoundChains, EverythingBelowTheRootsOfAGroupSways) {
    Sample sample;
    const std::vector<int> trunk = sample.add_line({"trunk1", "trunk2"}), other = sample.add_line({"other1", "other2"});
    const std::vector<int> left = sample.add_line({"left1", "left2"}, trunk[1]),
                           right = sample.add_line({"right1", "right2"}, trunk[1]);
    sample.add_group("", {trunk[0], left[0], other[0]});  // left stands below trunk, too
    const FoundChains found = chains_in(sample);
    EXPECT_EQ(found.chains.size(), 4U);
    for (const FoundChain& chain : found.chains) EXPECT_EQ(chain.found_by, FoundBy::kVrm0BoneGroup);
    EXPECT_EQ(chain_named(found, "left1").branches_from, 0U);
    EXPECT_FALSE(chain_named(found, "other1").branches_from);
}

TEST(FoundChains, LongerThanCoreMovesAreSkipped) {
    Person person;
    person.finish();
    EXPECT_EQ(chains_in(person, 3).chains.size(), 1U);
    EXPECT_EQ(reason_of(chains_in(person, 2), person.lock[0]), "too_long");
}

TEST(FoundChains, UnevenScalesAboveAreSkipped) {
    Person person;
    person.finish();
    person.node(person.head)["scale"] = {1, 1.2, 1};
    EXPECT_EQ(reason_of(chains_in(person), person.lock[0]), "sheared");
    person.node(person.head)["scale"] = {2, 2, 2};
    EXPECT_EQ(chains_in(person).chains.size(), 1U);
    person.node(person.head)["scale"] = {-1, -1, -1};
    EXPECT_EQ(reason_of(chains_in(person), person.lock[0]), "sheared");
}

}  // namespace
}  // namespace tuftwave::server::character
