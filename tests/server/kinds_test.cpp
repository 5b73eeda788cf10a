#include "character/kinds.hpp"

#include <gtest/gtest.h>

#include "character_samples.hpp"

namespace tuftwave::server::character {
namespace {

TEST(Kinds, NamesSayWhatTheyName) {
    const struct {
        const char* name;
        NameHint hint;
    } rows[] = {
        {"前髪1", NameHint::kHair},      {"後ろ髪.L.001", NameHint::kHair},   {"左もみあげ", NameHint::kHair},
        {"ﾂｲﾝﾃ左1", NameHint::kHair},    {"J_Sec_Hair1_01", NameHint::kHair}, {"FRONTHAIR", NameHint::kHair},
        {"Ponytail_3", NameHint::kHair}, {"bang.L", NameHint::kHair},         {"スカート_0_1", NameHint::kSkirt},
        {"ｽｶｰﾄ前", NameHint::kSkirt},    {"SkirtFront1", NameHint::kSkirt},   {"髪リボン", NameHint::kRibbon},
        {"ﾘﾎﾞﾝ右", NameHint::kRibbon},   {"HairRibbon_L", NameHint::kRibbon}, {"eyebrow_02", NameHint::kFace},
        {"brow1.l", NameHint::kFace},    {"EyeL", NameHint::kFace},           {"J_Adj_L_FaceEye", NameHint::kFace},
        {"右目", NameHint::kFace},       {"左眉", NameHint::kFace},           {"tongue01", NameHint::kFace},
        {"CatEar_R", NameHint::kOther},  {"tail_04", NameHint::kOther},       {"J_Sec_L_Bust1", NameHint::kOther}};
    for (const auto& row : rows) {
        ASSERT_TRUE(hint_of(row.name)) << row.name;
        EXPECT_EQ(*hint_of(row.name), row.hint) << row.name;
    }
}

TEST(Kinds, MostNamesSayNothing) {
    for (const char* const name :
         {"", "Bone.001", "brown", "Beard", "heart", "earth", "detail", "eyeglasses", "左腕", "ﾎﾞｰﾝ",
          "f81d4fae-7dec-11d0-a765-00a0c91e6bf6", "3E4FACE0-EA52-4BAD-BEEF-EACEADDED001", "stringent", "\xFF\xE9"}) {
        EXPECT_FALSE(hint_of(name)) << name;
    }
}

/// The index that is found among joints of these names below a root.
int head_among(std::initializer_list<const char*> names) {
    Sample sample;
    const int root = sample.add_node("root");
    std::vector<int> joints;
    for (const char* const name : names) joints.push_back(sample.add_node(name, root));
    sample.add_skin(joints);
    return find_head(read(sample));
}

TEST(Kinds, TheHeadIsTheJointThatIsCalledSo) {
    for (const char* const name :
         {"頭", "Head", "head", "HEAD", "J_Bip_C_Head", "mixamorig:Head", "Bip001 Head", "head.001"})
        EXPECT_EQ(head_among({"neck", name}), 2) << name;
    for (const char* const name : {"HeadTop_End", "mixamorig:HeadTop_End", "headset", "forehead", "head_end", "頭飾り"})
        EXPECT_EQ(head_among({"neck", name}), -1) << name;
    EXPECT_EQ(head_among({"HeadTop_End", "Head", "head"}), 2) << "the first in the file";
}

TEST(Kinds, TheHeadIsAJoint) {
    Sample sample;
    sample.add_node("Head");
    sample.add_skin({sample.add_node("root")});
    EXPECT_EQ(find_head(read(sample)), -1);
}

TEST(Kinds, VrmSaysWhichNodeTheHeadIs) {
    Sample sample;
    const std::vector<int> line = sample.add_line({"Head", "Kopf"});
    sample.add_skin(line);
    sample.set_bone("head", line[1]);
    EXPECT_EQ(find_head(read(sample)), line[1]);
}

}  // namespace
}  // namespace tuftwave::server::character
