#include "api/routes.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "assets/assets.hpp"
#include "support.hpp"

namespace tuftwave::server {
namespace {

/// "GET /v1/limits" and so on, from the lines of openapi.yaml that name paths and methods.
std::set<std::string> documented() {
    std::set<std::string> found;
    std::istringstream lines{std::string(asset("openapi.yaml").value())};
    std::string path;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("  /")) path = line.substr(2, line.size() - 3);
        if (line == "    get:") found.insert("GET " + path);
        if (line == "    post:") found.insert("POST " + path);
    }
    return found;
}

TEST(Routes, AreExactlyTheDocumentedOnes) {
    std::set<std::string> served;
    for (const Route& route : routes()) served.insert(std::string(route.method) + " " + std::string(route.path));
    EXPECT_EQ(served, documented());
}

TEST(Routes, TellApartWhatIsNotThereAndWhatIsNotAllowed) {
    EXPECT_EQ(slug_of(answer_to({"GET", "/v1/nothing", {}, {}, ""})), "not_found");
    EXPECT_EQ(slug_of(answer_to({"GET", "/v1/tufts/", {}, {}, ""})), "not_found");
    EXPECT_EQ(slug_of(answer_to({"GET", "/docs/../x", {}, {}, ""})), "not_found");
    const Answer answer = answer_to({"DELETE", "/v1/schedules", {}, {}, ""});
    ASSERT_EQ(slug_of(answer), "method_not_allowed");
    EXPECT_EQ(std::get<Problem>(answer).headers.front().second, "GET, HEAD, POST, OPTIONS");
}

TEST(Routes, HeadIsServedByGet) {
    EXPECT_EQ(std::get<Response>(answer_to({"HEAD", "/v1/version", {}, {}, ""})).status, 200);
}

}  // namespace
}  // namespace tuftwave::server
