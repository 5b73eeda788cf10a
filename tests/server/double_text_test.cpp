#include "gltf/double_text.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

namespace tuftwave::server::gltf {
namespace {

std::string text_of(double value) {
    char text[kDoubleTextBytes];
    return {text, write_double(text, value)};
}

TEST(DoubleText, HasAPointOrAnExponentAndTheFewestDigits) {
    EXPECT_EQ(text_of(-0.0), "-0.0");
    EXPECT_EQ(text_of(0.1), "0.1");
    EXPECT_EQ(text_of(-2.75), "-2.75");
    EXPECT_EQ(text_of(1200), "1200.0");
    EXPECT_EQ(text_of(0.1F), "0.10000000149011612");
    EXPECT_EQ(text_of(0.00012), "0.00012");
    EXPECT_EQ(text_of(0.000012), "1.2e-05");
    EXPECT_EQ(text_of(123456789012345680), "1.2345678901234568e+17");
}

TEST(DoubleText, TouchesNothingBehindIt) {
    for (const double value : {0.0, 0.1, -2.75, -0.1F * 1.0, 0.000012, 1e300}) {
        std::string text(2 * kDoubleTextBytes, '?');
        const auto bytes = static_cast<std::size_t>(write_double(text.data(), value) - text.data());
        EXPECT_EQ(text.find_first_not_of('?', bytes), std::string::npos) << value;
    }
}

TEST(DoubleText, IsWhatNlohmannMakesOfTheSameNumber) {
    std::uint64_t unlike = 0;
    const auto compare = [&](double value) {
        if (!std::isfinite(value)) return;
        const std::string text = text_of(value), wanted = nlohmann::json(value).dump();
        if (text != wanted && ++unlike < 10) ADD_FAILURE() << text << " is not " << wanted;
    };
    std::mt19937_64 random(1);
    for (int i = 0; i < 50'000; ++i) {
        const std::uint64_t bits = random();
        const double share = static_cast<double>(bits >> 11) * 0x1p-53;
        compare(std::bit_cast<double>(bits));
        compare(share);
        compare(static_cast<double>(static_cast<float>(share)));
        compare(std::ldexp(1 + share, static_cast<int>(bits % 96) - 90));  // around the range of exact products
        compare(static_cast<double>(bits % 1'000'000) * 1e-6);             // of few digits
        compare(static_cast<double>(bits % 1'000'000) / std::pow(10, bits % 17));
        compare(static_cast<double>(bits >> (bits % 64)));  // whole
        compare(std::ldexp(1.0, static_cast<int>(bits % 2099) - 1074));
    }
    // Grisu2 finds more digits than are needed for these.
    for (const double value : {0x1.dcbf3bd8bac3p-5, 0x1.8add8105cb79cp-2, 0x1.c8b02dfc4f5ccp-3}) compare(value);
    EXPECT_EQ(unlike, 0U);
}

}  // namespace
}  // namespace tuftwave::server::gltf
