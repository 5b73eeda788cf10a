#include "gltf/names.hpp"

#include <gtest/gtest.h>

namespace tuftwave::server::gltf {
namespace {

TEST(Names, KeepsWhatSurvivesEverywhere) {
    Names names;
    for (const char* const name : {"fringe", "A", "side_lock_L", "g01_003", "twelve_bytes"})
        EXPECT_EQ(names.claim(name, "tuft"), name);
}

TEST(Names, ReplacesWhatDoesNot) {
    Names names;
    const char* const lost[] = {"",   "前髪",     "thirteen_byte", "hair.001", "a b",      "1st",
                                "_x", "hair_col", "hair_COL",      "x_loop",   "hair_root"};
    for (const char* const name : lost) EXPECT_TRUE(names.claim(name, "tuft").starts_with("tuft_0")) << name;
}

TEST(Names, AreUnique) {
    Names names;
    EXPECT_EQ(names.claim("lock", "tuft"), "lock");
    EXPECT_EQ(names.claim("lock", "tuft"), "tuft_0001");
    EXPECT_EQ(names.claim("tuft_0002", "tuft"), "tuft_0002");
    EXPECT_EQ(names.claim("", "tuft"), "tuft_0003");
}

TEST(Names, JointsFitAVmdBoneName) {
    EXPECT_EQ(Names::joint("fringe", 1), "fringe_01");
    EXPECT_LE(Names::joint("twelve_bytes", 65).size(), 15U);
    EXPECT_LE(Names::joint("chain_16384", 65).size(), 15U);
}

}  // namespace
}  // namespace tuftwave::server::gltf
