#include "api/choose_chains.hpp"

#include <gtest/gtest.h>

namespace tuftwave::server {
namespace {

character::FoundChains chains() {
    character::FoundChains found;
    for (const auto& [name, kind] : {std::pair{"HairBall_L", character::Kind::kHair},
                                     {"HairBall_R", character::Kind::kHair},
                                     {"Ribbon", character::Kind::kRibbon},
                                     {"前髪１", character::Kind::kHair},
                                     {"2", character::Kind::kUnknown}}) {
        character::FoundChain& chain = found.chains.emplace_back();
        chain.name = name;
        chain.kind = kind;
    }
    return found;
}

std::vector<std::size_t> chosen(const std::string& names, const std::string& kinds = "") {
    const auto chosen = choose_chains(chains(), {names, kinds});
    if (const auto* indices = std::get_if<std::vector<std::size_t>>(&chosen)) return *indices;
    return {99};
}

Problem refused(const std::string& names, const std::string& kinds) {
    const auto chosen = choose_chains(chains(), {names, kinds});
    const auto* problem = std::get_if<Problem>(&chosen);
    EXPECT_NE(problem, nullptr);
    return problem != nullptr ? *problem : Problem{};
}

using Indices = std::vector<std::size_t>;

TEST(ChooseChains, WithoutAWishHairMoves) { EXPECT_EQ(chosen(""), (Indices{0, 1, 3})); }

TEST(ChooseChains, ByKind) {
    EXPECT_EQ(chosen("", "ribbon"), Indices{2});
    EXPECT_EQ(chosen("", "unknown,hair"), (Indices{0, 1, 3, 4}));
}

TEST(ChooseChains, ByIndexNameAndPatternEachOnceAndInOrder) {
    EXPECT_EQ(chosen("3,0"), (Indices{0, 3}));
    EXPECT_EQ(chosen("2"), Indices{2}) << "a number is an index, whatever is called so";
    EXPECT_EQ(chosen("Ribbon,HairBall_?,HairBall_R"), (Indices{0, 1, 2}));
    EXPECT_EQ(chosen("*_L"), Indices{0});
    EXPECT_EQ(chosen("*"), (Indices{0, 1, 2, 3, 4}));
    EXPECT_EQ(chosen("*a*B*l*"), (Indices{0, 1}));
}

TEST(ChooseChains, AQuestionMarkIsOneCharacterOfAnyLength) {
    EXPECT_EQ(chosen("前?１"), Indices{3});
    EXPECT_EQ(chosen("???"), Indices{3});
    EXPECT_EQ(refused("前??１", "").code, ProblemCode::kNotAChoice);
}

TEST(ChooseChains, SaysWhatFitsNothing) {
    for (const char* const word : {"5", "ribbon", "HairBall", "", "*x*"}) {
        const Problem problem = refused(std::string("Ribbon,") + word, "");
        EXPECT_EQ(problem.code, ProblemCode::kNotAChoice) << word;
        EXPECT_EQ(problem.fields.at(0).pointer, "?chains");
        EXPECT_EQ(std::get<std::string>(problem.fields.at(0).value), word);
    }
    EXPECT_EQ(refused("", "hair,beard").fields.at(0).pointer, "?kinds");
    EXPECT_EQ(refused("", "skirt").code, ProblemCode::kTooFew);
    EXPECT_EQ(refused("0", "hair").code, ProblemCode::kConflict);
}

}  // namespace
}  // namespace tuftwave::server
