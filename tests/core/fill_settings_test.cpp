#include "tuftwave/fill_settings.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "support.hpp"

namespace tuftwave {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(FillSettings, DefaultsAreAccepted) { EXPECT_FALSE(check_fill_settings({}, {})); }

TEST(FillSettings, NoDensityMayBeSaidInTwoWays) {
    FillSettings settings;
    settings.density = {0.0, {}, 0.0};
    EXPECT_FALSE(check_fill_settings(settings, {}));
    EXPECT_FALSE(is_on(settings.density.along));
    EXPECT_FALSE(is_on(settings.density.crown));
    EXPECT_TRUE(is_on(1.0));
}

TEST(FillSettings, AreRefusedWithCodeAndField) {
    const struct {
        const char* name;
        std::function<void(FillSettings&)> change;
        ErrorCode code;
        const char* field;
    } cases[] = {
        {"nearly no density", [](auto& s) { s.density.along = 0.5; }, ErrorCode::kOutOfRange, "/density/along"},
        {"negative density", [](auto& s) { s.density.crown = -1; }, ErrorCode::kOutOfRange, "/density/crown"},
        {"more than dense", [](auto& s) { s.density.neck = 100.5; }, ErrorCode::kOutOfRange, "/density/neck"},
        {"density not a number", [](auto& s) { s.density.neck = kNaN; }, ErrorCode::kNotFinite, "/density/neck"},
        {"none per metre", [](auto& s) { s.tufts_per_meter = 0; }, ErrorCode::kOutOfRange, "/tufts_per_meter"},
        {"negative gap", [](auto& s) { s.min_gap = -0.1; }, ErrorCode::kOutOfRange, "/min_gap"},
    };
    for (const auto& wrong : cases) {
        FillSettings settings;
        wrong.change(settings);
        EXPECT_TRUE(test::is_refused(check_fill_settings(settings, {}), wrong.code, wrong.field)) << wrong.name;
    }
}

}  // namespace
}  // namespace tuftwave
