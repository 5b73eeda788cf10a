#include "posed_hair.hpp"

#include <cmath>
#include <span>

namespace tuftwave::server::poses {
namespace {

TEST(PosedHair, BoneTurnsLeadFromTheParentsTurnToTheirOwn) {
    const SmallHair hair;
    for (std::size_t c = 0; c < hair.chains.size(); ++c) {
        const std::vector<Quat>& rotations = hair.motion.chains[c].rotations;
        const std::vector<Quat> turns = model_turns(hair.chains[c], rotations),
                                own = bone_turns(hair.chains[c], rotations);
        ASSERT_EQ(own.size(), turns.size());
        const std::size_t nodes = hair.chains[c].nodes.size();
        for (std::size_t at = 0; at < own.size(); ++at) {
            const Quat parent = at % nodes == 0 ? Quat{} : turns[at - 1];
            EXPECT_NEAR(std::abs(dot(parent * own[at], turns[at])), 1, 1e-14) << c << ", " << at;
            if (at >= nodes) {
                EXPECT_GT(dot(own[at], own[at - nodes]), 0) << c << ", " << at;
            }
        }
    }
}

TEST(PosedHair, NamesAreMadeLegalAndStayUnique) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    const BoneNames made = legal_names({{"a b", "a.b", "a_b"}, {"1st", "", "前", "_"}, {"root"}}, is_letter, "root");
    EXPECT_EQ(made, (BoneNames{{"a_b", "a_b_2", "a_b_3"}, {"_1st", "_", "___", "__2"}, {"root_2"}}));
}

TEST(PosedHair, NumbersAreShortAndHaveNoMinusBeforeZero) {
    std::string text;
    for (const double number : {0.1, -0.0, 24.0, -1e-9, 1.0 / 3, 1e6}) append_number(text += ' ', number);
    EXPECT_EQ(text, " 0.1 0 24 -1e-09 0.33333334 1e+06");
}

}  // namespace
}  // namespace tuftwave::server::poses
