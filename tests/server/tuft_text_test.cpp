#include "api/tuft_text.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "api/write_nouns.hpp"
#include "gltf/json_text.hpp"

namespace tuftwave::server {
namespace {

Tuft tuft_of_everything() {
    Tuft tuft;
    tuft.name = std::string("\"\\ \n\x01 \xE9\xAB\xAA");
    tuft.points = {{0.1, -0.0, 1e-300}, {1.0 / 3, 1e15, 12345678.9}, {-5e-324, 0.1 + 0.2, 100}};
    tuft.taper = Taper::kRound;
    tuft.section = Section::kEllipse;
    tuft.flatness = 0.25;
    tuft.twist_deg = -720;
    tuft.roll_deg = 1e-5;
    tuft.phase = -std::numeric_limits<double>::max();
    tuft.cycles = 2;
    tuft.origin = Origin{FillKind::kNeck, 3, 1};
    return tuft;
}

TEST(TuftText, SaysWhatTheTreeOfValuesSays) {
    Tuft plain = tuft_of_everything();
    plain.name.clear();
    plain.cycles.reset();
    plain.origin.reset();
    Tuft long_numbers = plain;
    long_numbers.points.assign(100, {-2.2250738585072014e-308, -1.7976931348623157e+308, -1.2345678901234567e-5});
    long_numbers.name.assign(64, '\x01');
    for (const Tuft& tuft : {tuft_of_everything(), plain, long_numbers}) {
        std::string text = "before";
        append_tuft(text, tuft);
        EXPECT_EQ(text, "before" + gltf::extras_text(nlohmann::json(tuft_json(tuft))));
    }
}

}  // namespace
}  // namespace tuftwave::server
