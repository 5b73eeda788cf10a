#include "tuftwave/skinning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "moving_chains.hpp"
#include "support.hpp"

namespace tuftwave {
namespace {

using test::hanging;
using test::moved;
using test::Random;
using test::with_rest_rotations;

Vec3 at(const std::vector<float>& numbers, std::size_t vertex) {
    const auto part = [&](std::size_t axis) { return static_cast<double>(numbers[3 * vertex + axis]); };
    return {part(0), part(1), part(2)};
}

PlannedTuft small_tuft() {
    Tuft tuft;
    tuft.points = {{0, 0.1, 0.02}, {0.02, 0.09, 0.09}, {0.03, 0.02, 0.12}};
    return *plan_tuft(tuft, {}, {}, {});
}

struct Posed {
    explicit Posed(const Mesh& rest, const Chain& chain, std::span<const Quat> rotations)
        : positions(rest.positions.size()), normals(rest.normals.size()) {
        write_posed_vertices(rest, chain, rotations, positions, normals);
    }
    std::vector<float> positions, normals;
};

TEST(Skinning, ARestPoseIsTheRestMesh) {
    const PlannedTuft tuft = small_tuft();
    const Mesh rest = to_mesh(tuft.mesh);
    const Posed posed(rest, tuft.chain, tuft.chain.rest_rotations);
    for (std::size_t i = 0; i < rest.positions.size(); ++i) {
        EXPECT_NEAR(posed.positions[i], rest.positions[i], 1e-7) << i;
        EXPECT_NEAR(posed.normals[i], rest.normals[i], 1e-6) << i;
    }
}

TEST(Skinning, ATurnOfTheRootTurnsEverything) {
    const PlannedTuft tuft = small_tuft();
    const Mesh rest = to_mesh(tuft.mesh);
    Random random(31);
    const Quat turn = random.rotation();
    std::vector<Quat> rotations = tuft.chain.rest_rotations;
    rotations[0] = turn * rotations[0];
    const Posed posed(rest, tuft.chain, rotations);
    const Vec3 root = tuft.chain.nodes[0];
    for (std::size_t vertex = 0; vertex < rest.positions.size() / 3; ++vertex) {
        EXPECT_LT(length(at(posed.positions, vertex) - (root + rotated(turn, at(rest.positions, vertex) - root))),
                  1e-7);
        EXPECT_LT(length(at(posed.normals, vertex) - rotated(turn, at(rest.normals, vertex))), 1e-6);
    }
}

// Weights are what is blended: a vertex that two bones share lies between where each alone would take it.
TEST(Skinning, BlendsWhereTwoBonesTakeAVertex) {
    Random random(32);
    const Chain chain = with_rest_rotations(hanging(), [&] { return random.rotation(); });
    const std::size_t nodes = chain.nodes.size();
    const ChainMotion motion = moved(chain, {});
    const auto rotations = std::span(motion.rotations).subspan(2 * nodes, nodes);
    const auto with_weights = [&](float first, float second) {
        Mesh mesh;
        mesh.positions = {0.08F, -0.01F, 0.02F};
        mesh.normals = {1, 0, 0};
        mesh.joints = {1, 2, 0, 0};
        mesh.weights = {first, second, 0, 0};
        return at(Posed(mesh, chain, rotations).positions, 0);
    };
    const Vec3 one = with_weights(1, 0), other = with_weights(0, 1);
    EXPECT_GT(length(one - other), 1e-4);
    EXPECT_LT(length(with_weights(0.25F, 0.75F) - (0.25 * one + 0.75 * other)), 1e-7);
    const auto turns = model_turns(chain, rotations);
    const auto places = node_positions(chain, rotations);
    const Vec3 vertex{0.08F, -0.01F, 0.02F};
    EXPECT_LT(length(one - (places[1] + rotated(turns[1], vertex - chain.nodes[1]))), 1e-7);
}

TEST(Skinning, NormalsStayUnitAndFiniteWhereBonesAreTurnedAgainstEachOther) {
    Chain chain = test::straight({0, -1, 0}, 2);
    Mesh mesh;
    mesh.positions = {0.1F, 0.05F, 0.3F};
    mesh.normals = {1, 0, 0};
    mesh.joints = {0, 1, 0, 0};
    mesh.weights = {0.5F, 0.5F, 0, 0};
    const std::vector<Quat> folded{{}, turn_about({0, 0, 1}, kPi), {}};
    const Posed posed(mesh, chain, folded);
    EXPECT_EQ(at(posed.normals, 0), (Vec3{1, 0, 0}));
}

}  // namespace
}  // namespace tuftwave
