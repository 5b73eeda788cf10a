#include "api/hairstyle_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "exec/pool.hpp"
#include "gltf/json_text.hpp"

namespace tuftwave::server {
namespace {

constexpr double kLong = -1.2345678901234567e-300;  // as long as numbers are written

Tuft tuft(const std::string& name) {
    Tuft made;
    made.name = name;
    made.points = {{0, 0.1, 0}, {0, 0, 0.1}};
    return made;
}

/// Whatever may be set, is.
Hairstyle everything() {
    Hairstyle hairstyle;
    hairstyle.head = {{0, 0.1, 0}, {0, 1, 0}, {0, 0, 1}, 0.02, 0.125, ScalpEllipsoid{Vec3{0, 0.1, 0}, {0.5, 0.25, 1}}};
    hairstyle.tufts = {tuft("a\n"), tuft("b")};
    FillSettings settings{
        "\"", {50, 2, std::nullopt}, 30, FillDirection::kShorter, Spacing::kHalfGap, Arc::kPath, false,
        0.5,  3'000'000'000};
    hairstyle.fills = {{0, 1, settings}};
    hairstyle.formulas = Formulas::kAsPrinted;
    Motion& motion = hairstyle.motion.emplace();
    motion.droop = Droop::kKeep;
    motion.lift = 0.25;
    motion.phase = {PhaseStep::kPicture, 0.5, 0.75, 9'007'199'254'740'991, 2};
    motion.timing.fps = {24'000, 1'001};
    hairstyle.mesh = {1e-3, 5, 6, false};
    return hairstyle;
}

std::string hairstyle_text(const Hairstyle& hairstyle, const gltf::Look& look, const ForEach& for_each) {
    std::string text = "before";
    append_hairstyle(text, hairstyle, look, for_each);
    EXPECT_TRUE(text.starts_with("before"));
    return text.substr(6);
}

/// The text as a tree of values would be written.
std::string written_anew(const std::string& text) { return gltf::extras_text(nlohmann::json::parse(text)); }

TEST(HairstyleText, SaysAllThatIsSet) {
    const std::string text = hairstyle_text(everything(), {gltf::Layout::kMerged, "#ff0000"}, InOrder());
    const std::string settings =
        R"({"fills":[{"arc":"path","density":{"along":50.0,"crown":2.0,"neck":0.0},"direction":"shorter",)"
        R"("formulas":"corrected","from":"a\n","jitter":{"seed":3000000000.0},"min_gap":0.5,"name":"\"",)"
        R"("resample":false,"spacing":"half_gap","to":"b","tufts_per_meter":30.0}],"formulas":"as_printed",)"
        R"("head":{"center":[0.0,0.1,0.0],"diameter_at_100":0.125,"front":[0.0,0.0,1.0],"root_depth":0.02,)"
        R"("scalp":{"ellipsoid":{"center":[0.0,0.1,0.0],"radii":[0.5,0.25,1.0]}},"up":[0.0,1.0,0.0]},)"
        R"("mesh":{"color":"#ff0000","layout":"merged","rings":5,"sides":6,"skin":false,"tolerance":0.001},)"
        R"("motion":{"droop":"keep","lift":0.25,"mode":"relative","one_sided":false,"phase":{"cycles":2,)"
        R"("gust_wavelength":0.5,"seed":9.007199254740991e+15,"spread":0.75,"step":"picture"},"timing":)"
        R"({"fps":"24000/1001","hold":2,"period":0.45,"sampling":"uniform","short_holds":"last"},)"
        R"("up":[0.0,1.0,0.0],"wave":{"amplitude":0.8,"lightness":1.2,"spatial_period":1.0,"tip_exponent":1.0},)"
        R"("wind":[1.0,0.0,0.0]},"tufts":[)";
    EXPECT_EQ(text.substr(0, settings.size()), settings);
    EXPECT_EQ(text, written_anew(text)) << "keys are in order, numbers in the usual form";
}

TEST(HairstyleText, LeavesOutWhatIsNotSet) {
    Hairstyle plain;
    plain.tufts = {tuft("a")};
    const std::string text = hairstyle_text(plain, {}, InOrder());
    for (const char* const key : {"fills", "formulas", "scalp", "motion", "rings", "skin"})
        EXPECT_EQ(text.find('"' + std::string(key) + '"'), std::string::npos) << key;
    EXPECT_EQ(text, written_anew(text));
}

TEST(HairstyleText, HasRoomForTheLongestOfAll) {
    Hairstyle hairstyle = everything();
    hairstyle.head.scalp =
        ScalpMesh{std::vector<Vec3>(1'000, Vec3{kLong, kLong, kLong}), {1'000, std::array<std::uint32_t, 3>{199'999}}};
    hairstyle.tufts[0].name.assign(64, '\x01');
    hairstyle.fills.assign(50, hairstyle.fills[0]);
    for (HairFill& fill : hairstyle.fills) {
        fill.settings.name.assign(48, '\x01');
        fill.settings.tufts_per_meter = fill.settings.min_gap = kLong;
        fill.settings.density = {kLong, kLong, kLong};
    }
    const std::string text = hairstyle_text(hairstyle, {}, InOrder());
    EXPECT_EQ(text, written_anew(text));
}

TEST(HairstyleText, IsTheSameForAnyNumberOfWorkers) {
    Hairstyle many;
    for (int i = 0; i < 300; ++i) many.tufts.push_back(tuft(std::to_string(i)));
    Pool pool(3, 8, std::chrono::seconds(1));
    EXPECT_EQ(hairstyle_text(many, {}, pool.for_each()), hairstyle_text(many, {}, InOrder()));
}

}  // namespace
}  // namespace tuftwave::server
