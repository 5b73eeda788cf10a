#include "character/character.hpp"

#include <gtest/gtest.h>

#include "character_samples.hpp"
#include "tuftwave/elementary.hpp"

namespace tuftwave::server::character {
namespace {

/// Two nodes, the second below the first and 1 m beside it, and one alone.
FileJson small_file() {
    return FileJson::parse(R"({"asset": {"version": "2.0"},
        "nodes": [{"children": [1]}, {"translation": [1, 0, 0]}, {}]})");
}

Character read(const FileJson& json) {
    Sample sample;
    sample.json = json;
    return character::read(sample);
}

/// Whether the second node counts as rigid below a first one of this kind.
bool is_rigid_below(const FileJson& first) {
    FileJson json = small_file();
    json["nodes"][0].update(first);
    return read(json).nodes[1].is_rigid;
}

TEST(Character, SaysWhatIsWrongAndWhere) {
    using Kind = Fault::Kind;
    const struct {
        const char* change;  // a JSON merge patch
        Kind kind;
        const char* pointer;
    } rows[] = {
        {R"({"asset": {"version": "1.0"}})", Kind::kUnsupported, "/asset/version"},
        {R"({"asset": {"version": 2}})", Kind::kWrongType, "/asset/version"},
        {R"({"asset": {"minVersion": "2.1"}})", Kind::kUnsupported, "/asset/minVersion"},
        {R"({"extensionsRequired": ["KHR_draco_mesh_compression"]})", Kind::kUnsupported, "/extensionsRequired/0"},
        {R"({"nodes": {}})", Kind::kWrongType, "/nodes"},
        {R"({"nodes": [3]})", Kind::kWrongType, "/nodes/0"},
        {R"({"nodes": [{"name": 3}]})", Kind::kWrongType, "/nodes/0/name"},
        {R"({"nodes": [{"children": [1]}]})", Kind::kOutOfRange, "/nodes/0/children/0"},
        {R"({"nodes": [{"children": [0]}]})", Kind::kConflict, "/nodes/0"},
        {R"({"nodes": [{}, {"children": [2]}, {"children": [1]}]})", Kind::kConflict, "/nodes/1"},
        {R"({"nodes": [{"children": [2]}, {"children": [2]}, {}]})", Kind::kConflict, "/nodes/1/children/0"},
        {R"({"nodes": [{"children": [1, 1]}, {}]})", Kind::kConflict, "/nodes/0/children/1"},
        {R"({"nodes": [{"rotation": [0, 0, 0, 0]}]})", Kind::kDegenerate, "/nodes/0/rotation"},
        {R"({"nodes": [{"rotation": [0, 0, 1]}]})", Kind::kWrongType, "/nodes/0/rotation"},
        {R"({"nodes": [{"translation": [0, 2e6, 0]}]})", Kind::kOutOfRange, "/nodes/0/translation/1"},
        {R"({"nodes": [{"scale": [1, 1, "1"]}]})", Kind::kWrongType, "/nodes/0/scale/2"},
        {R"({"nodes": [{"matrix": [1, 0, 0]}]})", Kind::kWrongType, "/nodes/0/matrix"},
        {R"({"skins": [{"joints": [0, 3]}]})", Kind::kOutOfRange, "/skins/0/joints/1"},
        {R"({"skins": [{"joints": [0, -1]}]})", Kind::kOutOfRange, "/skins/0/joints/1"},
        {R"({"skins": [{"joints": [0], "inverseBindMatrices": 0}]})", Kind::kOutOfRange,
         "/skins/0/inverseBindMatrices"},
    };
    for (const auto& row : rows) {
        FileJson json = small_file();
        json.merge_patch(FileJson::parse(row.change));
        const Fault fault = read_fault(json);
        EXPECT_EQ(fault.kind, row.kind) << row.change;
        EXPECT_EQ(fault.pointer, row.pointer) << row.change;
    }
}

TEST(Character, NeedsAnAssetWithAVersion) {
    FileJson json = small_file();
    json["asset"] = FileJson::object();
    EXPECT_EQ(read_fault(json).kind, Fault::Kind::kMissing);
    EXPECT_EQ(read_fault(json).pointer, "/asset/version");
    json.erase("asset");
    EXPECT_EQ(read_fault(json).kind, Fault::Kind::kMissing);
    EXPECT_EQ(read_fault(json).pointer, "/asset");
    EXPECT_NE(read_fault(FileJson::array()).pointer, "no fault");
}

TEST(Character, WithoutNodesHasNone) {
    const Character character = read(FileJson::parse(R"({"asset": {"version": "2.0"}})"));
    EXPECT_TRUE(character.nodes.empty());
    EXPECT_TRUE(character.order.empty());
    EXPECT_FALSE(character.faces_minus_z);
}

TEST(Character, PlacesNodesBelowTheirParents) {
    FileJson json = small_file();
    json["nodes"][0].update({{"translation", {0, 2, 0}}, {"rotation", {0, 0, 2, 2}}, {"scale", {3, 3, 3}}});
    const Character character = read(json);
    const Node& node = character.nodes[1];
    EXPECT_LT(length(node.model.origin - Vec3{0, 5, 0}), 1e-12) << "a quarter turn about Z, three times as far";
    EXPECT_NEAR(std::abs(dot(node.turn, turn_about({0, 0, 1}, kPi / 2))), 1, 1e-12);
    EXPECT_NEAR(dot(node.turn, node.turn), 1, 1e-12) << "a quaternion of any length is made a unit one";
    EXPECT_TRUE(node.is_rigid);
    EXPECT_EQ(node.parent, 0);
    EXPECT_EQ(character.nodes[2].parent, -1);
}

TEST(Character, ReadsAMatrixAsThreeParts) {
    FileJson json = small_file();
    json["nodes"][0]["matrix"] = {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 7, 8, 9, 1};
    const Node node = read(json).nodes[0];
    EXPECT_TRUE(node.has_matrix);
    EXPECT_LT(length(node.local.translation - Vec3{7, 8, 9}), 1e-12);
    EXPECT_LT(length(node.local.scale - Vec3{2, 2, 2}), 1e-12);
    EXPECT_NEAR(std::abs(dot(node.local.rotation, turn_about({0, 0, 1}, kPi / 2))), 1, 1e-12);
    EXPECT_TRUE(node.is_rigid);
    EXPECT_LT(length(read(json).nodes[1].model.origin - Vec3{7, 10, 9}), 1e-12);
}

TEST(Character, KnowsBelowWhatBonesDoNotTurn) {
    EXPECT_TRUE(is_rigid_below({{"scale", {2, 2, 2}}}));
    EXPECT_TRUE(is_rigid_below({{"scale", {2, 2, 2.001}}})) << "a thousandth is rounding";
    EXPECT_FALSE(is_rigid_below({{"scale", {2, 2, 2.01}}}));
    EXPECT_FALSE(is_rigid_below({{"scale", {1, 1, -1}}}));
    EXPECT_FALSE(is_rigid_below({{"scale", {-1, -1, -1}}}));
    EXPECT_FALSE(is_rigid_below({{"scale", {0, 0, 0}}}));
    EXPECT_TRUE(is_rigid_below({{"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1}}}));
    EXPECT_FALSE(is_rigid_below({{"matrix", {2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1}}})) << "uneven";
    EXPECT_FALSE(is_rigid_below({{"matrix", {1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}})) << "sheared";
    EXPECT_FALSE(is_rigid_below({{"matrix", {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}})) << "mirrored";
}

TEST(Character, AnUnevenScaleIsNoMatterToTheNodeThatHasIt) {
    FileJson json = small_file();
    json["nodes"][0]["scale"] = {1, 2, 3};
    EXPECT_TRUE(read(json).nodes[0].is_rigid);
    json["nodes"][0] = FileJson::parse(R"({"matrix": [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]})");
    EXPECT_FALSE(read(json).nodes[0].is_rigid) << "but a sheared matrix cannot be turned at all";
}

TEST(Character, ThatScalesItselfOutOfSightIsRefused) {
    Sample sample;
    int node = sample.add_node("root", -1, {1, 1, 1});
    for (int i = 0; i < 60; ++i) {
        sample.node(node)["scale"] = {1e6, 1e6, 1e6};
        node = sample.add_node("", node, {1, 1, 1});
    }
    const Fault fault = read_fault(sample.json);
    EXPECT_EQ(fault.kind, Fault::Kind::kOutOfRange);
    EXPECT_EQ(fault.pointer, "/nodes/1");
}

TEST(Character, OrdersParentsBeforeChildren) {
    const Character character = read(FileJson::parse(R"({"asset": {"version": "2.0"}, "nodes":
            [{}, {"children": [0, 3]}, {"children": [1]}, {"children": [4, 5]}, {}, {}, {}]})"));
    ASSERT_EQ(character.order.size(), 7U);
    std::vector<std::size_t> place(7);
    for (std::size_t i = 0; i < 7; ++i) place[static_cast<std::size_t>(character.order[i])] = i;
    for (std::size_t i = 0; i < 7; ++i) {
        const int parent = character.nodes[i].parent;
        if (parent >= 0) {
            EXPECT_LT(place[static_cast<std::size_t>(parent)], place[i]) << i;
        }
    }
}

TEST(Character, NumbersSayWhoIsBelowWhom) {
    const Character character = read(FileJson::parse(R"({"asset": {"version": "2.0"}, "nodes":
            [{}, {"children": [0, 3]}, {"children": [1]}, {"children": [4, 5]}, {}, {}, {}]})"));
    for (std::size_t above = 0; above < 7; ++above) {
        for (std::size_t below = 0; below < 7; ++below) {
            bool is_expected = false;
            for (int n = character.nodes[below].parent; n >= 0; n = character.nodes[static_cast<std::size_t>(n)].parent)
                is_expected = is_expected || n == static_cast<int>(above);
            EXPECT_EQ(is_below(character.nodes[below], character.nodes[above]), is_expected) << below << " " << above;
        }
    }
}

TEST(Character, MayBeOneLongLine) {
    constexpr int kMost = 65'536;
    FileJson nodes = FileJson::array();
    for (int i = 0; i + 1 < kMost; ++i) nodes.push_back({{"children", {i + 1}}});
    nodes.push_back(FileJson::object());
    FileJson json{{"asset", {{"version", "2.0"}}}, {"nodes", nodes}};
    const Character character = read(json);
    ASSERT_EQ(character.nodes.size(), static_cast<std::size_t>(kMost));
    for (std::size_t i = 0; i < character.nodes.size(); ++i) {
        ASSERT_EQ(character.order[i], static_cast<int>(i));
        ASSERT_EQ(character.nodes[i].first, i);
        ASSERT_EQ(character.nodes[i].last, character.nodes.size());
    }
    json["nodes"].push_back(FileJson::object());
    EXPECT_EQ(read_fault(json).kind, Fault::Kind::kTooMany);
    EXPECT_EQ(read_fault(json).pointer, "/nodes");
}

}  // namespace
}  // namespace tuftwave::server::character
