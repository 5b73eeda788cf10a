#include "tuftwave/head.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "support.hpp"

namespace tuftwave {
namespace {

using test::are_near;
using test::is_refused;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(CheckHead, AcceptsTheDefault) { EXPECT_FALSE(check_head({}, {})); }

TEST(CheckHead, RefusesWithCodeAndField) {
    const struct {
        const char* name;
        std::function<void(Head&)> change;
        ErrorCode code;
        const char* field;
    } cases[] = {
        {"center far away", [](Head& h) { h.center.y = 1e7; }, ErrorCode::kOutOfRange, "/center/1"},
        {"center not a number", [](Head& h) { h.center.x = kNaN; }, ErrorCode::kNotFinite, "/center/0"},
        {"up without length", [](Head& h) { h.up = {}; }, ErrorCode::kDegenerate, "/up"},
        {"up not a number", [](Head& h) { h.up.z = kNaN; }, ErrorCode::kNotFinite, "/up/2"},
        {"front without length", [](Head& h) { h.front = {}; }, ErrorCode::kDegenerate, "/front"},
        {"front along up",
         [](Head& h) {
             h.front = {0, 2, 0};
         },
         ErrorCode::kDegenerate, "/front"},
        {"front against up",
         [](Head& h) {
             h.front = {0, -2, 0};
         },
         ErrorCode::kDegenerate, "/front"},
        {"negative depth", [](Head& h) { h.root_depth = -0.01; }, ErrorCode::kOutOfRange, "/root_depth"},
        {"depth not a number", [](Head& h) { h.root_depth = kNaN; }, ErrorCode::kNotFinite, "/root_depth"},
        {"no diameter", [](Head& h) { h.diameter_at_100 = 0; }, ErrorCode::kOutOfRange, "/diameter_at_100"},
    };
    for (const auto& wrong : cases) {
        Head head;
        wrong.change(head);
        EXPECT_TRUE(is_refused(check_head(head, {}), wrong.code, wrong.field)) << wrong.name;
    }
}

TEST(SunkRoot, LiesTheDepthBelowTheScalpTowardsTheCenter) {
    Head head;
    head.center = {1, 2, 3};
    head.root_depth = 0.01;
    EXPECT_TRUE(are_near(sunk_root(head, {1, 2.1, 3}), {1, 2.09, 3}, 1e-15));

    test::Random random(1);
    for (int i = 0; i < 100; ++i) {
        const Vec3 root = head.center + random.between(0.02, 5) * random.direction();
        const Vec3 sunk = sunk_root(head, root);
        EXPECT_NEAR(length(sunk - root), 0.01, 1e-14);
        EXPECT_NEAR(length(sunk - head.center), length(root - head.center) - 0.01, 1e-14);
    }
}

TEST(SunkRoot, NeverPassesTheCenter) {
    Head head;
    head.root_depth = 0.2;
    EXPECT_EQ(sunk_root(head, {0, 0.1, 0}), head.center);
    EXPECT_EQ(sunk_root(head, {0, 0.2, 0}), head.center);
}

TEST(SunkRoot, WithoutDepthIsTheRootItself) {
    Head head;
    head.root_depth = 0;
    const Vec3 root{0.03, 0.1, -0.02};
    EXPECT_EQ(sunk_root(head, root), root);
}

}  // namespace
}  // namespace tuftwave
