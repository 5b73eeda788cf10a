#include "api/drawn_lines.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support.hpp"

namespace tuftwave::server {
namespace {

/// What is wrong with a body's lines, as slug and pointer; "" where nothing is.
std::string fault(const char* text) {
    const JsonDocument body = parsed(text);
    FieldProblems problems;
    Drawing drawing;
    read_fitted_lines(body.root(), Place(), problems, {}, drawing);
    if (problems.empty()) return "";
    const FieldProblem first = problems.take().front();
    return std::string(slug(first.code)) + " " + first.pointer;
}

TEST(DrawnLines, HaveTwoOrThreeNumbersPerNode) {
    const JsonDocument body = parsed(R"({"name": "a", "pictures": [[[1, 2], [3, 4, 5]]], "rest": []})");
    FieldProblems problems;
    Drawing drawing;
    read_fitted_lines(body.root(), Place(), problems, {}, drawing);
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(drawing.name, "a");
    EXPECT_EQ(drawing.pictures, (std::vector<Line>{{{1, 2, 0}, {3, 4, 5}}}));
    ASSERT_TRUE(drawing.rest);
    EXPECT_TRUE(drawing.rest->empty());  // for core to refuse
}

TEST(DrawnLines, NameWhatIsWrong) {
    EXPECT_EQ(fault(R"({"pictures": []})"), "");
    EXPECT_EQ(fault(R"({})"), "missing_field /pictures");
    EXPECT_EQ(fault(R"({"pictures": [7]})"), "wrong_type /pictures/0");
    EXPECT_EQ(fault(R"({"pictures": [[], [[1]]]})"), "wrong_type /pictures/1/0");
    EXPECT_EQ(fault(R"({"pictures": [[[1, null]]]})"), "wrong_type /pictures/0/0/1");
    EXPECT_EQ(fault(R"({"pictures": [], "rest": [[0, 0, 0, 0]]})"), "wrong_type /rest/0");
    EXPECT_EQ(fault(R"({"pictures": [], "rest_length": 1})"), "unknown_field /rest_length");
}

TEST(DrawnLines, AreOffByDegreesAndPercent) {
    const nlohmann::json json = error_json(MotionError{{kPi, 0.5}, {{kPi, 0.5}, {kPi / 2, 0}}});
    EXPECT_DOUBLE_EQ(json["angle_deg"].get<double>(), 180);
    EXPECT_DOUBLE_EQ(json["position_percent"].get<double>(), 50);
    EXPECT_DOUBLE_EQ(json["pictures"][1]["angle_deg"].get<double>(), 90);
}

}  // namespace
}  // namespace tuftwave::server
