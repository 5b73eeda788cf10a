#include "api/float_text.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "api/write_nouns.hpp"

namespace tuftwave::server {
namespace {

std::string text_of(float value) {
    char text[kFloatTextBytes];
    return {text, write_float(text, value)};
}

TEST(FloatText, HasAPointOrAnExponentAndTheFewestDigits) {
    EXPECT_EQ(text_of(0.0F), "0.0");
    EXPECT_EQ(text_of(-0.0F), "-0.0");
    EXPECT_EQ(text_of(1.0F), "1.0");
    EXPECT_EQ(text_of(-2.5F), "-2.5");
    EXPECT_EQ(text_of(0.1F), "0.1");
    EXPECT_EQ(text_of(1200.0F), "1200.0");
    EXPECT_EQ(text_of(16777215.0F), "16777215.0");
    EXPECT_EQ(text_of(0.00012F), "0.00012");
    EXPECT_EQ(text_of(0.000012F), "1.2e-05");
    EXPECT_EQ(text_of(1e-30F), "1e-30");
}

TEST(FloatText, IsWhatNlohmannMakesOfTheSameNumber) {
    std::uint64_t unlike = 0;
    const auto compare = [&](float value) {
        if (!std::isfinite(value)) return;
        const std::string text = text_of(value);
        const std::string wanted = nlohmann::json(short_number(static_cast<double>(value))).dump();
        EXPECT_LE(text.size(), static_cast<std::size_t>(kFloatTextBytes));
        if (text != wanted && ++unlike < 10) ADD_FAILURE() << text << " is not " << wanted;
    };
    std::mt19937 random(1);
    for (int i = 0; i < 50'000; ++i) {
        const auto bits = static_cast<std::uint32_t>(random());
        compare(std::bit_cast<float>(bits));
        compare(static_cast<float>(bits) * 0x1p-32F);            // from 0 to 1
        compare(static_cast<float>(bits % 100'000) / 1'000.0F);  // of few digits
        compare(static_cast<float>(bits % 0x2000000));           // whole, around the limit
        compare(std::ldexp(1.0F, static_cast<int>(bits % 277) - 149));
    }
    // Grisu2 finds more digits than are needed for these.
    for (const float value : {-0x1.5ba8b4p-1F, 0x1.c9b5bp-3F, 0x1.7b6b38p-1F, 0x1.d948d6p-110F}) compare(value);
    for (const float value : {std::numeric_limits<float>::max(), std::numeric_limits<float>::min(),
                              std::numeric_limits<float>::denorm_min()})
        compare(value);
    EXPECT_EQ(unlike, 0U);
}

}  // namespace
}  // namespace tuftwave::server
