#include "poses/vmd.hpp"

#include <array>
#include <bit>
#include <cstdint>

#include "posed_hair.hpp"

namespace tuftwave::server::poses {
namespace {

constexpr std::size_t kFirstKey = 54, kKeyBytes = 111;

SmallHair hair_at_30() { return SmallHair(kVmdRate); }

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes.at(at + i));
    return word;
}

double float_at(const std::string& bytes, std::size_t at) {
    return static_cast<double>(std::bit_cast<float>(word_at(bytes, at)));
}

std::string vmd_of(const SmallHair& hair, int repeat = 1) {
    const Result<std::string> made = vmd(hair.posed(), repeat);
    EXPECT_TRUE(made) << (made ? "" : made.error().field);
    return made ? *made : "";
}

TEST(Vmd, PicturesHaveAKeyAtTheirFirstAndTheirLastFrame) {
    const SmallHair hair = hair_at_30();  // T 0.45: 14 frames, 7 pictures on twos
    const std::vector<VmdKey> keys = vmd_keys(hair.motion.schedule, 2);
    ASSERT_EQ(keys.size(), 2 * 14U + 1);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const int frame = static_cast<int>(i);
        EXPECT_EQ(keys[i].frame, frame);
        EXPECT_EQ(keys[i].picture, picture_at(hair.motion.schedule, frame));
        EXPECT_EQ(keys[i].is_change, frame > 0 && frame % 2 == 0) << frame;
    }
}

TEST(Vmd, LongHoldsHaveNoKeyBetweenAndSinglesOnlyOne) {
    Schedule schedule;
    schedule.frames = 6;
    schedule.pictures = 2;
    schedule.starts = {0, 5};
    schedule.holds = {5, 1};
    std::vector<std::array<int, 3>> keys;
    for (const VmdKey& key : vmd_keys(schedule, 1)) keys.push_back({key.frame, key.picture, key.is_change});
    EXPECT_EQ(keys, (std::vector<std::array<int, 3>>{{0, 0, 0}, {4, 0, 0}, {5, 1, 1}, {6, 0, 1}}));
}

TEST(Vmd, HasTheSizeAndTheSectionsThatReadersExpect) {
    const std::string bytes = vmd_of(hair_at_30());
    EXPECT_EQ(bytes.size(), 74 + kKeyBytes * 3 * 15);
    EXPECT_EQ(bytes.substr(0, 30), std::string("Vocaloid Motion Data 0002") + std::string(5, '\0'));
    EXPECT_EQ(bytes.substr(30, 20), "hair" + std::string(16, '\0'));
    EXPECT_EQ(word_at(bytes, 50), 3 * 15U);
    EXPECT_EQ(bytes.substr(bytes.size() - 20), std::string(20, '\0'));
}

TEST(Vmd, EveryKeySwitchesPhysicsOffAndHidesTheChange) {
    const std::string bytes = vmd_of(hair_at_30());
    for (std::size_t key = 0; key < 45; ++key) {
        const std::string curves = bytes.substr(kFirstKey + kKeyBytes * key + 47, 64);
        EXPECT_EQ(curves[2], '\x63') << key;
        EXPECT_EQ(curves[3], '\x0f') << key;
        const bool is_change = key % 15 > 0 && key % 15 % 2 == 0;
        for (std::size_t axis = 0; axis < 4; ++axis) {  // as readers take them: row by axis, every fourth byte
            const int wanted[] = {20, 20, 107, 107}, hidden[] = {127, 0, 127, 0};
            for (std::size_t part = 0; part < 4; ++part) {
                const auto got = static_cast<unsigned char>(curves[16 * axis + 4 * part]);
                EXPECT_EQ(got, is_change ? hidden[part] : wanted[part]) << key << ", " << axis << ", " << part;
            }
        }
    }
}

TEST(Vmd, RotationsAreRelativeToRestInMmdsAxes) {
    const SmallHair hair = hair_at_30();
    const std::string bytes = vmd_of(hair);
    const std::vector<Quat> turns = bone_turns(hair.chains[1], hair.motion.chains[1].rotations);
    const std::size_t key = kFirstKey + kKeyBytes * (2 * 15 + 4);  // the only bone of the second chain at frame 4
    const Quat& turn = turns[2 * 2];
    EXPECT_EQ(bytes.substr(key, 15), "b_01" + std::string(11, '\0'));
    EXPECT_EQ(word_at(bytes, key + 15), 4U);
    const double wanted[] = {0, 0, 0, -turn.x, -turn.y, turn.z, turn.w};
    for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(float_at(bytes, key + 19 + 4 * i), wanted[i], 1e-7) << i;
}

TEST(Vmd, NamesAreWrittenInCodePage932OrRefused) {
    SmallHair hair = hair_at_30();
    hair.names[1][0] = "左右前後髪尾先";  // seven full-width characters are 14 bytes
    EXPECT_EQ(vmd_of(hair).substr(kFirstKey + kKeyBytes * 30, 4), "\x8d\xb6\x89\x45");
    for (const char* const name : {"左右前後髪尾先端", "sixteen_bytes_01", "cheveux_é", ""}) {
        hair.names[1][0] = name;
        const Result<std::string> refused = vmd(hair.posed(), 1);
        ASSERT_FALSE(refused) << name;
        EXPECT_EQ(refused.error().code, ErrorCode::kConflict);
        EXPECT_EQ(refused.error().field, "/1");
        EXPECT_EQ(std::get<std::string>(refused.error().given), name);
    }
}

}  // namespace
}  // namespace tuftwave::server::poses
