#include "poses/bvh.hpp"

#include <sstream>

#include "posed_hair.hpp"

namespace tuftwave::server::poses {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST(Bvh, TellsTheSkeletonInModelAxes) {
    const std::string text = bvh(SmallHair().posed());
    EXPECT_TRUE(text.starts_with(
        "HIERARCHY\nROOT hair_root\n{\n  OFFSET 0 0 0\n  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
        "Yrotation\n"
        "  JOINT a_01\n  {\n    OFFSET 0 1 0\n    CHANNELS 3 Zrotation Xrotation Yrotation\n"
        "    JOINT a_02\n    {\n      OFFSET 0 -0.5 0\n      CHANNELS 3 Zrotation Xrotation Yrotation\n"
        "      End Site\n      {\n        OFFSET 0 -0.25 0.1\n      }\n    }\n  }\n"
        "  JOINT b_01\n  {\n    OFFSET 1 0 0\n"))
        << text;
}

TEST(Bvh, RepeatsTheLineOfAPictureWhileItIsHeld) {
    const SmallHair hair;
    const std::vector<std::string> lines = lines_of(bvh(hair.posed()));
    const auto motion = std::find(lines.begin(), lines.end(), "MOTION");
    ASSERT_EQ(lines.end() - motion, 3 + 11);
    EXPECT_EQ(motion[1], "Frames: 11");
    EXPECT_EQ(motion[2], "Frame Time: 0.041666666667");
    for (int frame = 1; frame < 11; ++frame) {
        const bool is_held = picture_at(hair.motion.schedule, frame) == picture_at(hair.motion.schedule, frame - 1);
        EXPECT_EQ(motion[3 + frame] == motion[2 + frame], is_held) << frame;
    }
    for (auto line = motion + 3; line != lines.end(); ++line)
        EXPECT_EQ(std::count(line->begin(), line->end(), ' ') + 1, 6 + 3 * 3) << *line;
}

TEST(Bvh, NamesLoseBlanksAndBraces) {
    SmallHair hair;
    hair.names = {{"a b", "a{b}"}, {"前髪"}};
    const std::string text = bvh(hair.posed());
    for (const char* const line : {"JOINT a_b\n", "JOINT a_b_\n", "JOINT 前髪\n"})
        EXPECT_NE(text.find(line), std::string::npos) << line;
}

}  // namespace
}  // namespace tuftwave::server::poses
