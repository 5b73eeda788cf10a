#include "api/query_body.hpp"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "support.hpp"

namespace tuftwave::server {
namespace {

constexpr std::array<QueryField, 4> kFields{{{"period", "/timing/period"},
                                             {"wind", "/wind"},
                                             {"name", "/name", QueryValue::kText},
                                             {"phases", "/phases", QueryValue::kNumbers}}};

nlohmann::json body_of(const NameValues& query) {
    Request request;
    request.query = query;
    return as_plain(query_body(request, kFields).root());
}

TEST(QueryBody, ReadsEachValueAsWhatItLooksLike) {
    EXPECT_EQ(body_of({{"period", "0.5"}})["timing"]["period"], 0.5);
    EXPECT_EQ(body_of({{"period", "-1e-3"}})["timing"]["period"], -1e-3);
    EXPECT_EQ(body_of({{"wind", "1,0,-2.5"}})["wind"], (nlohmann::json{1, 0, -2.5}));
    EXPECT_EQ(body_of({{"wind", "true"}})["wind"], true);
    for (const char* const text : {"", "0x10", "1e999", "nan", "inf", "1,", ",", "1,x", " 1", "24000/1001", "True"})
        EXPECT_EQ(body_of({{"wind", text}})["wind"], text) << text;
}

TEST(QueryBody, KeepsTextAndMakesLists) {
    EXPECT_EQ(body_of({{"name", "12"}})["name"], "12");
    EXPECT_EQ(body_of({{"name", "true"}})["name"], "true");
    EXPECT_EQ(body_of({{"phases", "1.5"}})["phases"], nlohmann::json::array({1.5}));
    EXPECT_EQ(body_of({{"phases", "1,2"}})["phases"], (nlohmann::json{1, 2}));
}

TEST(QueryBody, LeavesOutWhatHasNoRow) {
    EXPECT_EQ(body_of({{"format", "glb"}, {"zzz", "1"}}), nlohmann::json::object());
}

TEST(QueryBody, ProblemsAreNamedAndQuotedAsInTheQuery) {
    Request request;
    request.query = {{"wind", "1,0"}, {"period", "99"}};
    const Problem found = fields_problem({{ProblemCode::kWrongType, "/wind", "array", "three numbers", {}, {}},
                                          {ProblemCode::kOutOfRange, "/timing/period", 99.0, "0 to 60", {}, {}},
                                          {ProblemCode::kOutOfRange, "/phases/3", 1.0, "", {}, {}},
                                          {ProblemCode::kOutOfRange, "/windy", 1.0, "", {}, {}}});
    const Problem named = as_query_problem(found, kFields, request);
    ASSERT_EQ(named.fields.size(), 4U);
    EXPECT_EQ(named.fields[0].pointer, "?wind");
    EXPECT_EQ(std::get<std::string>(named.fields[0].value), "1,0");
    EXPECT_EQ(named.fields[1].pointer, "?period");
    EXPECT_EQ(std::get<double>(named.fields[1].value), 99.0);
    EXPECT_EQ(named.fields[2].pointer, "?phases");
    EXPECT_EQ(named.fields[3].pointer, "/windy");
    EXPECT_NE(named.detail.find("?wind"), std::string::npos);
}

}  // namespace
}  // namespace tuftwave::server
