#include "api/schedules.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support.hpp"

namespace tuftwave::server {
namespace {

Answer get(const NameValues& query, const NameValues& headers = {}) {
    return answer_to({"GET", "/v1/schedules", query, headers, ""});
}

std::string header_of(const Answer& answer, const std::string& name) {
    for (const auto& [key, value] : std::get<Response>(answer).headers) {
        if (key == name) return value;
    }
    return "";
}

TEST(Schedules, GetAndPostGiveTheSameBytes) {
    const Answer by_query = get({{"period", "0.45"}, {"fps", "24000/1001"}, {"hold", "3"}, {"short_holds", "spread"}});
    const Answer by_body = answer_to(
        json_post("/v1/schedules", R"({"timing":{"period":0.45,"fps":"24000/1001","hold":3,"short_holds":"spread"}})"));
    EXPECT_EQ(std::get<Response>(by_query).body, std::get<Response>(by_body).body);
}

TEST(Schedules, WhoeverHasTheAnswerGetsNoBody) {
    const std::string tag = header_of(get({}), "ETag");
    EXPECT_EQ(std::get<Response>(get({}, {{"if-none-match", tag}})).status, 304);
    EXPECT_EQ(std::get<Response>(get({}, {{"if-none-match", "\"0\""}})).status, 200);
    EXPECT_NE(header_of(get({{"period", "0.5"}}), "ETag"), tag);
}

TEST(Schedules, NameTheQueryParameterThatIsWrong) {
    EXPECT_EQ(pointer_of(get({{"period", "99"}})), "?period");
    EXPECT_EQ(pointer_of(get({{"period", "abc"}})), "?period");
    EXPECT_EQ(pointer_of(get({{"hold", "2.5"}})), "?hold");
    EXPECT_EQ(pointer_of(get({{"fps", "24/0"}})), "?fps");
    EXPECT_EQ(pointer_of(get({{"speed", "1"}})), "?speed");
    EXPECT_EQ(pointer_of(get({{"period", "1"}, {"period", "2"}})), "?period");
}

TEST(Schedules, ASheetHasAnEnd) {
    EXPECT_EQ(pointer_of(answer_to(json_post("/v1/schedules", R"({"timing":{"period":30,"hold":24},"repeat":1000})"))),
              "/timing/period");
    EXPECT_EQ(pointer_of(answer_to(json_post("/v1/schedules", R"({"timing":{"period":20,"hold":24},"repeat":1440})"))),
              "/repeat");
}

}  // namespace
}  // namespace tuftwave::server
