#include "character/riding.hpp"

#include "character_samples.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/motion.hpp"

namespace tuftwave::server::character {
namespace {

Quat turn_deg(const Vec3& axis, double degrees) { return turn_about(normalized(axis), degrees * kRadiansPerDegree); }

void turn(Sample& sample, int node, const Quat& q) { sample.node(node)["rotation"] = {q.x, q.y, q.z, q.w}; }

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

/// A chain with nodes between its bones, on a turned parent, each node turned its own way at rest.
struct Turned {
    Sample sample;
    Character character;
    FoundChains found;
    Chain chain;
    std::vector<ChainMotion> moved;

    Turned() {
        const int head = sample.add_node("head", -1, {0.1, 1.5, 0.2});
        turn(sample, head, turn_deg({1, 2, 3}, 77));
        const std::vector<int> line = sample.add_line({"a", "between1", "between2", "b", "c", "d"}, head);
        turn(sample, line[0], turn_deg({0, 0, 1}, 180));
        turn(sample, line[1], turn_deg({1, 0, 1}, 30));
        turn(sample, line[2], turn_deg({0, 1, 1}, -50));
        turn(sample, line[3], turn_deg({1, 0, 0}, 20));
        turn(sample, line[4], turn_deg({0, 1, 0}, 175));
        sample.add_spring("", {line[0], line[3], line[4], line[5]});
        character = read(sample);
        found = chains_in(sample);
        chain = to_chain(character, found, found.chains.at(0));
        const auto schedule = make_schedule({}, Formulas::kCorrected, {});
        moved = *move_chains(std::span(&chain, 1), {}, *schedule, {}, InOrder(), {});
    }
};

/// Where the file's own nodes come to lie, from what each states and what a clip says instead.
std::vector<Vec3> places(const Character& character, const std::vector<std::pair<int, Quat>>& clip) {
    std::vector<Vec3> places(character.nodes.size());
    std::vector<Quat> turns(character.nodes.size());
    for (const int index : character.order) {
        const Node& node = character.nodes[static_cast<std::size_t>(index)];
        Quat rotation = node.local.rotation;
        for (const auto& [moved, keyed] : clip) rotation = moved == index ? keyed : rotation;
        const auto slot = static_cast<std::size_t>(index);
        const bool is_root = node.parent < 0;
        const Quat above = is_root ? Quat{} : turns[static_cast<std::size_t>(node.parent)];
        const Vec3 from = is_root ? Vec3{} : places[static_cast<std::size_t>(node.parent)];
        places[slot] = from + rotated(above, node.local.translation);
        turns[slot] = above * rotation;
    }
    return places;
}

TEST(ToNodeRotation, PutsTheFilesNodesWhereCoreHasThem) {
    const Turned turned;
    const FoundChain& chain = turned.found.chains[0];
    ASSERT_EQ(chain.bones.size(), 3U);
    const std::size_t nodes = turned.chain.nodes.size();
    for (std::size_t first = 0; first < turned.moved[0].rotations.size(); first += nodes) {
        const auto rotations = std::span(turned.moved[0].rotations).subspan(first, nodes);
        std::vector<std::pair<int, Quat>> clip;
        for (std::size_t i = 0; i < chain.bones.size(); ++i)
            clip.emplace_back(chain.bones[i], to_node_rotation(turned.character, chain, i, rotations[i]));
        const std::vector<Vec3> by_file = places(turned.character, clip);
        const std::vector<Vec3> by_core = node_positions(turned.chain, rotations);
        for (std::size_t i = 0; i < chain.bones.size(); ++i)
            expect_near(by_file[static_cast<std::size_t>(chain.bones[i])], by_core[i], 1e-12);
        expect_near(by_file[static_cast<std::size_t>(*chain.tip_node)], by_core.back(), 1e-12);
    }
}

TEST(ToNodeRotation, AtRestIsWhatTheNodeStates) {
    const Turned turned;
    const FoundChain& chain = turned.found.chains[0];
    for (std::size_t i = 0; i < chain.bones.size(); ++i) {
        const Quat stated = turned.character.nodes[static_cast<std::size_t>(chain.bones[i])].local.rotation;
        const Quat made = to_node_rotation(turned.character, chain, i, turned.chain.rest_rotations[i]);
        EXPECT_NEAR(std::abs(dot(stated, made)), 1, 1e-12);
    }
}

TEST(Riding, ABranchHangsOnTheLastBoneOfItsTrunk) {
    Sample sample;
    const std::vector<int> trunk = sample.add_line({"t1", "t2", "t3"});
    const std::vector<int> left = sample.add_line({"l1", "l2"}, trunk[2]),
                           right = sample.add_line({"r1", "r2"}, trunk[2]);
    sample.add_group("", {trunk[0]});
    const Character character = read(sample);
    const FoundChains found = chains_in(sample);
    const auto rides = find_rides(character, found.chains);
    ASSERT_EQ(rides.size(), 3U);
    EXPECT_FALSE(rides[0]);
    for (const std::size_t branch : {1U, 2U}) {
        ASSERT_TRUE(rides[branch]);
        EXPECT_EQ(rides[branch]->chain, 0U);
        EXPECT_EQ(rides[branch]->bone, 1U);
    }
}

TEST(Riding, CarriersComeBeforeWhatTheyCarry) {
    Sample sample;
    const std::vector<int> line = sample.add_line({"a1", "a2", "b1", "b2", "c1", "c2"});
    sample.add_spring("c", {line[4], line[5]});
    sample.add_spring("b", {line[2], line[3]});
    sample.add_spring("a", {line[0], line[1]});
    const Character character = read(sample);
    const FoundChains found = chains_in(sample);
    EXPECT_EQ(riding_order(character, found.chains), (std::vector<std::size_t>{2, 1, 0}));
    const auto rides = find_rides(character, found.chains);
    EXPECT_EQ(rides[0]->chain, 1U);
    EXPECT_EQ(rides[1]->chain, 2U);
    EXPECT_FALSE(rides[2]);
}

}  // namespace
}  // namespace tuftwave::server::character
