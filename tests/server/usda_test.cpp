#include "poses/usda.hpp"

#include "posed_hair.hpp"

namespace tuftwave::server::poses {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Usda, TellsUnitsAxesAndRate) {
    const std::string text = usda(SmallHair({24'000, 1'001}).posed());
    EXPECT_TRUE(text.starts_with("#usda 1.0\n(\n    defaultPrim = \"hair\"\n    endTimeCode = 10\n")) << text;
    for (const char* const line :
         {"    framesPerSecond = 23.976023976023978\n", "    timeCodesPerSecond = 23.976023976023978\n",
          "    metersPerUnit = 1\n", "    upAxis = \"Y\"\n", "rel skel:animationSource = </hair/skeleton/wave>\n"})
        EXPECT_TRUE(has(text, line)) << line;
}

TEST(Usda, JointsArePathsAndMatricesActOnRows) {
    const std::string text = usda(SmallHair().posed());
    EXPECT_TRUE(has(text, "uniform token[] joints = [\"a_01\", \"a_01/a_02\", \"b_01\"]\n")) << text;
    // The third joint's axes: half a turn about Y, then 2 atan(3/4) about X. Its origin stands in the last row.
    EXPECT_TRUE(has(text, "( (-1, 0, 0, 0), (0, 0.28, 0.96, 0), (0, 0.96, -0.28, 0), (1, 0, 0, 1) )]\n")) << text;
    EXPECT_TRUE(has(text, "float3[] translations = [(0, 1, 0), (0, -0.5, 0), (1, 0, 0)]\n")) << text;
}

TEST(Usda, EachPictureHasTwoSamplesAndTheFirstOneClosesTheLoop) {
    const std::string text = usda(SmallHair().posed());
    std::size_t at = text.find("rotations.timeSamples");
    std::string first, before;
    for (const char* const time :
         {"0", "1.999", "2", "3.999", "4", "5.999", "6", "7.999", "8", "9.999", "10", "10.999", "11"}) {
        const std::string label = "\n                " + std::string(time) + ": ";
        at = text.find(label, at);
        ASSERT_NE(at, std::string::npos) << time;
        const std::string list = text.substr(at + label.size(), text.find('\n', at + 1) - at - label.size());
        const bool is_end = std::string(time).ends_with(".999");
        EXPECT_EQ(list == before, is_end) << time;
        if (first.empty()) first = list;
        before = list;
    }
    EXPECT_EQ(before, first);
}

TEST(Usda, NamesAreLegalPrimNames) {
    SmallHair hair;
    hair.names = {{"前髪", "hair.001"}, {"1st"}};
    EXPECT_TRUE(has(usda(hair.posed()), "[\"______\", \"______/hair_001\", \"_1st\"]"));
}

}  // namespace
}  // namespace tuftwave::server::poses
