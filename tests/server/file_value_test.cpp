#include "character/file_value.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace tuftwave::server::character {
namespace {

constexpr Range kSmall{-2, 2};

/// A file and its first fault.
struct File {
    explicit File(const char* text) : json(FileJson::parse(text)) {}

    FileValue value() { return {&json, "", fault}; }

    FileJson json;
    std::optional<Fault> fault;
};

TEST(FileValue, ReadsWhatIsThere) {
    File file(
        R"({"text": "a", "flag": true, "whole": 7, "list": [0, 2], "point": [1, -1.5, 2], "object": {"b": 1, "a": 2}})");
    const FileValue value = file.value();
    EXPECT_EQ(value["text"].text(), "a");
    EXPECT_TRUE(value["flag"].flag());
    EXPECT_EQ(value["whole"].whole(7), 7U);
    EXPECT_EQ(value["whole"].index(8), 7);
    EXPECT_EQ(value["list"].indices(3), (std::vector<int>{0, 2}));
    EXPECT_EQ(value["list"].size(), 2U);
    EXPECT_EQ(value["point"].numbers<3>(kSmall), (std::array<double, 3>{1, -1.5, 2}));
    EXPECT_EQ(value["object"].keys(), (std::vector<std::string>{"b", "a"})) << "in the file's order";
    EXPECT_EQ(value["object"]["a"].pointer(), "/object/a");
    EXPECT_EQ(value["list"].at(1).pointer(), "/list/1");
    EXPECT_FALSE(file.fault);
}

TEST(FileValue, ReadsWhatIsAbsentAsNothing) {
    File file("{}");
    const FileValue absent = file.value()["a"]["b"];
    EXPECT_FALSE(absent.exists());
    EXPECT_EQ(absent.size(), 0U);
    EXPECT_TRUE(absent.keys().empty());
    EXPECT_EQ(absent.text(), "");
    EXPECT_FALSE(absent.flag());
    EXPECT_FALSE(absent.whole(9));
    EXPECT_FALSE(absent.index(9));
    EXPECT_FALSE(absent.index(0)) << "an index into nothing is no fault where there is none";
    EXPECT_TRUE(absent.indices(9).empty());
    EXPECT_FALSE(absent.numbers<3>(kSmall));
    EXPECT_FALSE(file.fault);
}

TEST(FileValue, SaysWhatIsWrongAndWhere) {
    using Kind = Fault::Kind;
    const struct {
        const char* text;
        std::function<void(const FileValue&)> ask;
        Kind kind;
        const char* pointer;
    } rows[] = {
        {R"({"a": 1})", [](const FileValue& v) { v["a"]["b"].exists(); }, Kind::kWrongType, "/a"},
        {R"([])", [](const FileValue& v) { v["a"].exists(); }, Kind::kWrongType, ""},
        {R"({"a": {}})", [](const FileValue& v) { v["a"].size(); }, Kind::kWrongType, "/a"},
        {R"({"a": null})", [](const FileValue& v) { v["a"].size(); }, Kind::kWrongType, "/a"},
        {R"({"a": []})", [](const FileValue& v) { v["a"].keys(); }, Kind::kWrongType, "/a"},
        {R"({"a": 1})", [](const FileValue& v) { v["a"].text(); }, Kind::kWrongType, "/a"},
        {R"({"a": 1})", [](const FileValue& v) { v["a"].flag(); }, Kind::kWrongType, "/a"},
        {R"({"a": "1"})", [](const FileValue& v) { v["a"].whole(9); }, Kind::kWrongType, "/a"},
        {R"({"a": 10})", [](const FileValue& v) { v["a"].whole(9); }, Kind::kOutOfRange, "/a"},
        {R"({"a": -1})", [](const FileValue& v) { v["a"].whole(9); }, Kind::kOutOfRange, "/a"},
        {R"({"a": 0.5})", [](const FileValue& v) { v["a"].whole(9); }, Kind::kOutOfRange, "/a"},
        {R"({"a": 1e300})", [](const FileValue& v) { v["a"].whole(9); }, Kind::kOutOfRange, "/a"},
        {R"({"a": 9})", [](const FileValue& v) { v["a"].index(9); }, Kind::kOutOfRange, "/a"},
        {R"({"a": 0})", [](const FileValue& v) { v["a"].index(0); }, Kind::kOutOfRange, "/a"},
        {R"({"a": [0, 9]})", [](const FileValue& v) { v["a"].indices(9); }, Kind::kOutOfRange, "/a/1"},
        {R"({"a": [0, -1]})", [](const FileValue& v) { v["a"].indices(9); }, Kind::kOutOfRange, "/a/1"},
        {R"({"a": [4294967296]})", [](const FileValue& v) { v["a"].indices(9); }, Kind::kOutOfRange, "/a/0"},
        {R"({"a": [[]]})", [](const FileValue& v) { v["a"].indices(9); }, Kind::kWrongType, "/a/0"},
        {R"({"a": 3})", [](const FileValue& v) { v["a"].indices(9); }, Kind::kWrongType, "/a"},
        {R"({"a": [1, 2]})", [](const FileValue& v) { v["a"].numbers<3>(kSmall); }, Kind::kWrongType, "/a"},
        {R"({"a": [1, "2"]})", [](const FileValue& v) { v["a"].numbers<2>(kSmall); }, Kind::kWrongType, "/a/1"},
        {R"({"a": [1, 3]})", [](const FileValue& v) { v["a"].numbers<2>(kSmall); }, Kind::kOutOfRange, "/a/1"},
        {R"({"a/b": {"~c": 1}})", [](const FileValue& v) { v["a/b"]["~c"].text(); }, Kind::kWrongType, "/a~1b/~0c"},
    };
    for (const auto& row : rows) {
        File file(row.text);
        row.ask(file.value());
        ASSERT_TRUE(file.fault) << row.text;
        EXPECT_EQ(file.fault->kind, row.kind) << row.text;
        EXPECT_EQ(file.fault->pointer, row.pointer) << row.text;
        EXPECT_FALSE(file.fault->allowed.empty()) << row.text;
    }
}

TEST(FileValue, GivesBackWhatWasGivenAndTheRange) {
    File file(R"({"a": 10})");
    EXPECT_FALSE(file.value()["a"].whole(9));
    ASSERT_TRUE(file.fault);
    EXPECT_EQ(std::get<double>(file.fault->given), 10);
    EXPECT_EQ(file.fault->minimum, 0);
    EXPECT_EQ(file.fault->maximum, 9);

    File text(R"({"a": "no number"})");
    EXPECT_FALSE(text.value()["a"].whole(9));
    ASSERT_TRUE(text.fault);
    EXPECT_EQ(std::get<std::string>(text.fault->given), "no number");
}

TEST(FileValue, KeepsTheFirstFault) {
    File file(R"({"a": 10, "b": "text"})");
    EXPECT_EQ(file.value()["b"].size(), 0U);
    EXPECT_FALSE(file.value()["a"].whole(9));
    ASSERT_TRUE(file.fault);
    EXPECT_EQ(file.fault->pointer, "/b");
    EXPECT_FALSE(file.fault->maximum) << "a later fault's range is none of the first one's";
}

}  // namespace
}  // namespace tuftwave::server::character
