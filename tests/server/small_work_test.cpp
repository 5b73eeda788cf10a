#include "service/small_work.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tuftwave::server {
namespace {

const Route& route_of(const std::string& path) { return *std::get<const Route*>(find_route("POST", path)); }

TEST(SmallWork, IsAShortBodyOfARouteThatCountsBound) {
    EXPECT_TRUE(may_be_small(route_of("/v1/tufts"), 2'048));
    EXPECT_FALSE(may_be_small(route_of("/v1/tufts"), 2'049));
    for (const char* path : {"/v1/fits", "/v1/fills", "/v1/hairstyles", "/v1/evaluations", "/v1/characters/motion"})
        EXPECT_FALSE(may_be_small(route_of(path), 1)) << path;
}

TEST(SmallWork, HasNoLimitThatOthersHaveNot) {
    Limits tiny;
    tiny.tufts = tiny.points = tiny.points_per_tuft = tiny.rings_per_tuft = tiny.vertices = tiny.triangles = 1;
    tiny.sheet_frames = 1;
    const Limits small = small_limits(tiny);
    for (const std::size_t count : {small.tufts, small.points, small.points_per_tuft, small.rings_per_tuft,
                                    small.vertices, small.triangles, small.sheet_frames})
        EXPECT_EQ(count, 1u);
    EXPECT_LT(small_limits({}).vertices, Limits{}.vertices);
}

}  // namespace
}  // namespace tuftwave::server
