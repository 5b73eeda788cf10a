#include "api/reader.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support.hpp"

namespace tuftwave::server {
namespace {

/// Reads one field named "x" of a body and says what came of it: "" when nothing was wrong, else slug and pointer.
template <class Read>
std::string outcome(const std::string& body, Read read) {
    const JsonDocument document = parsed(body);
    FieldProblems problems;
    const Place root;
    Fields fields(document.root(), root, problems);
    read(fields);
    fields.done();
    if (problems.empty()) return "";
    const FieldProblem first = problems.take().front();
    return std::string(slug(first.code)) + " " + first.pointer;
}

TEST(Reader, LeavesDefaultsAloneWhereAFieldIsAbsent) {
    double number = 7;
    EXPECT_EQ(outcome("{}", [&](Fields& f) { f.number("x", number); }), "");
    EXPECT_EQ(number, 7);
}

TEST(Reader, ReadsNumbersAndNothingElseAsNumbers) {
    double number = 0;
    const auto read = [&](Fields& f) { f.number("x", number); };
    EXPECT_EQ(outcome(R"({"x":0.25})", read), "");
    EXPECT_EQ(number, 0.25);
    EXPECT_EQ(outcome(R"({"x":-3})", read), "");
    EXPECT_EQ(number, -3);
    for (const char* const body : {R"({"x":"1"})", R"({"x":true})", R"({"x":null})", R"({"x":[1]})", R"({"x":{}})"}) {
        EXPECT_EQ(outcome(body, read), "wrong_type /x") << body;
    }
}

TEST(Reader, ReadsWholeNumbersWithoutEverOverflowing) {
    int whole = 0;
    const auto read = [&](Fields& f) { f.integer("x", {1, 9}, whole); };
    EXPECT_EQ(outcome(R"({"x":6.0})", read), "");
    EXPECT_EQ(whole, 6);
    EXPECT_EQ(outcome(R"({"x":6.5})", read), "wrong_type /x");
    for (const char* const body : {R"({"x":0})", R"({"x":10})", R"({"x":1e300})", R"({"x":-1e300})",
                                   R"({"x":18446744073709551615})", R"({"x":4294967297})"}) {
        EXPECT_EQ(outcome(body, read), "out_of_range /x") << body;
    }
    EXPECT_EQ(whole, 6);
}

TEST(Reader, NullEmptiesWhatMayBeEmpty) {
    std::optional<double> number = 1;
    std::optional<int> whole = 1;
    std::optional<Vec3> vector = Vec3{};
    EXPECT_EQ(outcome(R"({"x":null,"y":null,"z":null})",
                      [&](Fields& f) {
                          f.number("x", number);
                          f.integer("y", {0, 9}, whole);
                          f.vector("z", vector);
                      }),
              "");
    EXPECT_FALSE(number || whole || vector);
}

TEST(Reader, WhetherMayBeLeftOpen) {
    std::optional<bool> flag;
    const auto read = [&](Fields& f) { f.boolean("x", flag); };
    EXPECT_EQ(outcome("{}", read), "");
    EXPECT_EQ(flag, std::nullopt);
    EXPECT_EQ(outcome(R"({"x":false})", read), "");
    EXPECT_EQ(flag, false);
    EXPECT_EQ(outcome("{}", read), "");
    EXPECT_EQ(flag, false);
    EXPECT_EQ(outcome(R"({"x":true})", read), "");
    EXPECT_EQ(flag, true);
    EXPECT_EQ(outcome(R"({"x":null})", read), "");
    EXPECT_EQ(flag, std::nullopt);
    for (const char* const body : {R"({"x":0})", R"({"x":"true"})", R"({"x":[]})"}) {
        EXPECT_EQ(outcome(body, read), "wrong_type /x") << body;
    }
}

TEST(Reader, AnEmptyTextIsNotAMissingOne) {
    std::optional<std::string> text;
    const auto read = [&](Fields& f) { f.text("x", 3, text); };
    EXPECT_EQ(outcome("{}", read), "");
    EXPECT_EQ(text, std::nullopt);
    EXPECT_EQ(outcome(R"({"x":""})", read), "");
    EXPECT_EQ(text, "");
    EXPECT_EQ(outcome(R"({"x":"前髪1"})", read), "");  // characters count, not bytes
    EXPECT_EQ(text, "前髪1");
    EXPECT_EQ(outcome(R"({"x":null})", read), "");
    EXPECT_EQ(text, std::nullopt);
    EXPECT_EQ(outcome(R"({"x":"four"})", read), "too_many /x");
    EXPECT_EQ(outcome(R"({"x":4})", read), "wrong_type /x");
}

TEST(Reader, NamesTheItemThatIsWrong) {
    std::vector<Vec3> points;
    const auto read = [&](Fields& f) { f.vectors("x", 2, points); };
    EXPECT_EQ(outcome(R"({"x":[[0,1,2],[3,4,5]]})", read), "");
    EXPECT_EQ(points, (std::vector<Vec3>{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(outcome(R"({"x":[[0,1,2],[3,"4",5]]})", read), "wrong_type /x/1/1");
    EXPECT_EQ(outcome(R"({"x":[[0,1,2],[3,4]]})", read), "wrong_type /x/1");
    EXPECT_EQ(outcome(R"({"x":{}})", read), "wrong_type /x");
    EXPECT_EQ(outcome(R"({"x":[1,2,3]})", read), "too_many /x");  // refused unread
}

TEST(Reader, ReadsFlatListsOfVectors) {
    std::vector<Vec3> positions;
    const auto read = [&](Fields& f) { f.flat_vectors("x", 2, positions); };
    EXPECT_EQ(outcome(R"({"x":[0,1,2,3,4.5,5]})", read), "");
    EXPECT_EQ(positions, (std::vector<Vec3>{{0, 1, 2}, {3, 4.5, 5}}));
    positions.clear();
    EXPECT_EQ(outcome(R"({"x":[]})", read), "");  // whether that is too few is for core to say
    EXPECT_EQ(outcome("{}", read), "");
    EXPECT_TRUE(positions.empty());
    EXPECT_EQ(outcome(R"({"x":[0,1,2,3]})", read), "wrong_type /x");
    EXPECT_EQ(outcome(R"({"x":[0,1]})", read), "wrong_type /x");
    EXPECT_EQ(outcome(R"({"x":[0,1,2,3,"4",5]})", read), "wrong_type /x/4");
    EXPECT_EQ(outcome(R"({"x":[0,null,2]})", read), "wrong_type /x/1");
    EXPECT_EQ(outcome(R"({"x":[[0,1,2],[3,4,5],[6,7,8]]})", read), "wrong_type /x/0");
    EXPECT_EQ(outcome(R"({"x":null})", read), "wrong_type /x");
    EXPECT_EQ(outcome(R"({"x":{}})", read), "wrong_type /x");
    EXPECT_EQ(outcome(R"({"x":["a","b","c","d","e","f","g","h","i"]})", read), "too_many /x");  // refused unread
}

TEST(Reader, ReadsFlatListsOfTriples) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const auto read = [&](Fields& f) { f.flat_triples("x", 2, {0, 9}, triangles); };
    EXPECT_EQ(outcome(R"({"x":[0,1,2.0,7,8,9]})", read), "");
    EXPECT_EQ(triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {7, 8, 9}}));
    EXPECT_EQ(outcome(R"({"x":[0,1,2,3]})", read), "wrong_type /x");
    EXPECT_EQ(outcome(R"({"x":[0,1,2.5]})", read), "wrong_type /x/2");
    EXPECT_EQ(outcome(R"({"x":[0,true,2]})", read), "wrong_type /x/1");
    for (const char* const vertex : {"-1", "10", "1e300", "4294967296", "18446744073709551616"}) {
        EXPECT_EQ(outcome(std::string(R"({"x":[0,)") + vertex + ",2]}", read), "out_of_range /x/1") << vertex;
    }
    EXPECT_EQ(outcome(R"({"x":[0,1,2,3,4,5,6,7,8]})", read), "too_many /x");
    EXPECT_EQ(triangles.size(), 2U);
}

TEST(Reader, FindsFieldsThatNobodyAskedFor) {
    double number = 0;
    EXPECT_EQ(outcome(R"({"x":1,"amplitud":2})", [&](Fields& f) { f.number("x", number); }), "unknown_field /amplitud");
    EXPECT_EQ(outcome(R"({"a/b~c":2})", [](Fields&) {}), "unknown_field /a~1b~0c");
}

TEST(Reader, NamesUnknownFieldsAndKnownOnesByTheAlphabet) {
    const JsonDocument document = parsed(R"({"z":1,"x":1,"b":1,"":1})");
    FieldProblems problems;
    const Place root;
    Fields fields(document.root(), root, problems);
    double number = 0;
    std::optional<double> other;
    fields.require("x");
    fields.number("x", number);
    fields.number("a", other);
    fields.done();
    const std::vector<FieldProblem> found = problems.take();
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].pointer, "/");
    EXPECT_EQ(found[1].pointer, "/b");
    EXPECT_EQ(found[2].pointer, "/z");
    for (const FieldProblem& each : found) EXPECT_EQ(each.allowed, "a, x");
}

TEST(Reader, FindsEachOfManyFields) {
    nlohmann::json body;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < 64; ++i) body[names.emplace_back(i, 'k')] = i;
    std::vector<double> read(64, -1);
    EXPECT_EQ(outcome(body.dump(),
                      [&](Fields& f) {
                          for (std::size_t i = 0; i < 64; ++i) f.number(names[i], read[i]);
                      }),
              "");
    for (std::size_t i = 0; i < 64; ++i) EXPECT_EQ(read[i], static_cast<double>(i));
}

TEST(Reader, SaysWhichChoicesThereAre) {
    enum class Word { kOn, kOff };
    constexpr Choices<Word, 2> kWords{{{"on", Word::kOn}, {"off", Word::kOff}}};
    Word word = Word::kOn;
    const auto read = [&](Fields& f) { f.choice("x", kWords, word); };
    EXPECT_EQ(outcome(R"({"x":"off"})", read), "");
    EXPECT_EQ(word, Word::kOff);
    EXPECT_EQ(outcome(R"({"x":"Off"})", read), "not_a_choice /x");
    EXPECT_EQ(outcome(R"({"x":1})", read), "not_a_choice /x");
}

TEST(Reader, ReadsFrameRatesAsNumbersAndFractions) {
    FrameRate fps;
    const auto read = [&](Fields& f) { f.frame_rate("x", fps); };
    EXPECT_EQ(outcome(R"({"x":30})", read), "");
    EXPECT_EQ(fps, (FrameRate{30, 1}));
    EXPECT_EQ(outcome(R"({"x":"24000/1001"})", read), "");
    EXPECT_EQ(fps, (FrameRate{24000, 1001}));
    EXPECT_EQ(outcome(R"({"x":23.976})", read), "");
    EXPECT_EQ(fps, (FrameRate{2997, 125}));
    for (const char* const text : {"", "/", "24/", "/24", "-24/1", "24/1/1", "abc", "24 ", "1e", "99999999/1"}) {
        EXPECT_EQ(outcome(nlohmann::json{{"x", text}}.dump(), read), "wrong_type /x") << text;
    }
}

TEST(Reader, StopsCollectingAfterSixteenProblems) {
    FieldProblems problems;
    for (int i = 0; i < 100; ++i) problems.add({});
    EXPECT_EQ(problems.take().size(), 16U);
}

}  // namespace
}  // namespace tuftwave::server
