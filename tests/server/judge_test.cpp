#include "character/judge.hpp"

#include "character_samples.hpp"

namespace tuftwave::server::character {
namespace {

/// A skeleton from the floor to the head; chains of two nodes hang on its parts.
struct Body : Sample {
    int hips = add_node("hips", -1, {0, 1, 0}), chest = add_node("chest", hips, {0, 0.3, 0}),
        head = add_node("head", chest, {0, 0.3, 0}), foot = add_node("foot", hips, {0, -1, 0});
    std::vector<int> joints{hips, chest, head, foot};

    std::vector<int> hang(int parent, const std::string& name, double down = 0.1) {
        const int root = add_node(name, parent, {0, 0, 0});
        const int tip = add_node(name + "_end", root, {0, -down, 0});
        joints.insert(joints.end(), {root, tip});
        return {root, tip};
    }
    FoundChains find() {
        add_skin(joints);
        return chains_in(*this);
    }
};

TEST(Judge, NamesDecideWhatHangsOnTheHead) {
    Body body;
    for (const char* const name :
         {"HairJoint-245c78de", "\xE5\x89\x8D\xE9\xAB\xAA", "0a1b2c", "ribbon_hair", "cat_ear"})
        body.hang(body.head, name);
    const std::vector<int> brow = body.hang(body.head, "brow.l");
    const FoundChains found = body.find();
    EXPECT_EQ(chain_named(found, "HairJoint-245c78de").kind, Kind::kHair);
    EXPECT_EQ(chain_named(found, "\xE5\x89\x8D\xE9\xAB\xAA").kind, Kind::kHair);
    EXPECT_EQ(chain_named(found, "0a1b2c").kind, Kind::kHair) << "nothing in its name, but it hangs on the head";
    EXPECT_EQ(chain_named(found, "ribbon_hair").kind, Kind::kRibbon);
    EXPECT_EQ(chain_named(found, "cat_ear").kind, Kind::kUnknown);
    EXPECT_EQ(reason_of(found, brow[0]), "face");
}

TEST(Judge, WhatHangsElsewhereNeedsAName) {
    Body body;
    body.hang(body.chest, "ponytail");
    body.hang(body.hips, "\xEF\xBD\xBD\xEF\xBD\xB6\xEF\xBD\xB0\xEF\xBE\x84");  // half-width kana
    const std::vector<int> arm = body.hang(body.chest, "upper_arm"), tail = body.hang(body.hips, "tail");
    const FoundChains found = body.find();
    EXPECT_EQ(chain_named(found, "ponytail").kind, Kind::kHair);
    EXPECT_EQ(chain_named(found, "\xEF\xBD\xBD\xEF\xBD\xB6\xEF\xBD\xB0\xEF\xBE\x84").kind, Kind::kSkirt);
    EXPECT_EQ(reason_of(found, arm[0]), "body");
    EXPECT_EQ(reason_of(found, tail[0]), "body");
}

TEST(Judge, SpringsAroundTheHipsAreASkirtIfThereAreSeveral) {
    for (const int count : {2, 3}) {
        Body body;
        for (int i = 0; i < count; ++i) body.add_spring("", body.hang(body.hips, "s" + std::to_string(i)));
        body.set_bone("hips", body.hips);
        body.set_bone("head", body.head);
        const FoundChain chain = chain_named(body.find(), "s0");
        EXPECT_EQ(chain.kind, count == 3 ? Kind::kSkirt : Kind::kUnknown) << count;
    }
}

TEST(Judge, ASpringsOwnNameCountsWhereTheNodesSayNothing) {
    Body body;
    body.add_spring("Ribbon", body.hang(body.chest, "x"));
    EXPECT_EQ(chain_named(body.find(), "x").kind, Kind::kRibbon);
}

TEST(Judge, WithoutAHeadTheHighestAreHair) {
    Body body;
    body.node(body.head)["name"] = "N3";
    body.hang(body.head, "high");
    body.hang(body.head, "beside");  // without it the head itself were part of a chain
    body.hang(body.hips, "low");
    const FoundChains found = body.find();
    EXPECT_EQ(found.head, -1);
    EXPECT_EQ(chain_named(found, "high").kind, Kind::kHair);
    EXPECT_EQ(chain_named(found, "high").because, (std::vector<std::string_view>{"skin_joints", "at_head_height"}));
    EXPECT_EQ(chain_named(found, "low").kind, Kind::kUnknown);
}

TEST(Judge, TheMiddleOfTheHeadLiesHalfAsHighAsTheHighestRoot) {
    Body body;
    const int high = body.add_node("top", body.head, {0, 0.2, 0}), end = body.add_node("top_end", high);
    body.joints.insert(body.joints.end(), {high, end});
    const FoundChains found = body.find();
    EXPECT_NEAR(found.head_center.y, 1.6 + 0.1, 1e-12);
}

}  // namespace
}  // namespace tuftwave::server::character
