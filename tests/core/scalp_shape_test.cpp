#include "tuftwave/scalp_shape.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "scalp_shapes.hpp"
#include "support.hpp"

namespace tuftwave {
namespace {

using test::is_refused;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(ScalpShape, NoneAndWellFormedOnesAreAccepted) {
    EXPECT_FALSE(check_scalp_shape({}, {}));
    EXPECT_FALSE(check_scalp_shape(ScalpEllipsoid{{}, {0.08, 0.11, 0.1}}, {}));
    EXPECT_FALSE(check_scalp_shape(test::sphere_mesh({}, 0.1, 4), {}));
}

TEST(ScalpShape, AnEllipsoidIsRefusedWithCodeAndField) {
    const struct {
        const char* name;
        std::function<void(ScalpEllipsoid&)> change;
        ErrorCode code;
        const char* field;
    } cases[] = {
        {"flat", [](ScalpEllipsoid& e) { e.radii.y = 0; }, ErrorCode::kOutOfRange, "/ellipsoid/radii/1"},
        {"not a number", [](ScalpEllipsoid& e) { e.radii.z = kNaN; }, ErrorCode::kNotFinite, "/ellipsoid/radii/2"},
        {"far away",
         [](ScalpEllipsoid& e) {
             e.center = {1e7, 0, 0};
         },
         ErrorCode::kOutOfRange, "/ellipsoid/center/0"},
    };
    for (const auto& wrong : cases) {
        ScalpEllipsoid ellipsoid{Vec3{}, {0.1, 0.1, 0.1}};
        wrong.change(ellipsoid);
        EXPECT_TRUE(is_refused(check_scalp_shape(ellipsoid, {}), wrong.code, wrong.field)) << wrong.name;
    }
}

TEST(ScalpShape, AMeshIsRefusedAtTheNumberInItsFlatList) {
    const struct {
        const char* name;
        std::function<void(ScalpMesh&)> change;
        ErrorCode code;
        const char* field;
    } cases[] = {
        {"two vertices", [](ScalpMesh& m) { m.positions.resize(2); }, ErrorCode::kTooFew, "/mesh/positions"},
        {"no triangle", [](ScalpMesh& m) { m.triangles.clear(); }, ErrorCode::kTooFew, "/mesh/triangles"},
        {"not a number", [](ScalpMesh& m) { m.positions[2].y = kNaN; }, ErrorCode::kNotFinite, "/mesh/positions/7"},
        {"no such vertex", [](ScalpMesh& m) { m.triangles[1][2] = 12345; }, ErrorCode::kOutOfRange,
         "/mesh/triangles/5"},
    };
    for (const auto& wrong : cases) {
        ScalpMesh mesh = test::sphere_mesh({}, 0.1, 4);
        wrong.change(mesh);
        EXPECT_TRUE(is_refused(check_scalp_shape(mesh, {}), wrong.code, wrong.field)) << wrong.name;
    }
    Limits limits;
    limits.scalp_triangles = 10;
    EXPECT_TRUE(
        is_refused(check_scalp_shape(test::sphere_mesh({}, 0.1, 4), limits), ErrorCode::kTooMany, "/mesh/triangles"));
}

}  // namespace
}  // namespace tuftwave
