#include "sheets/xdts.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tuftwave::server::sheets {
namespace {

Schedule example() { return *make_schedule({}, Formulas::kCorrected, {}); }  // T 0.45, 24 fps, on twos

const std::vector<std::string> kOneTrack{"hair"};

/// The picture on each frame, as OpenToonz expands a track: a value stays until the next entry.
std::vector<std::string> expanded(const std::string& xdts) {
    const auto json = nlohmann::json::parse(xdts.substr(xdts.find('\n') + 1));
    const auto& table = json["timeTables"][0];
    std::vector<std::string> frames(table["duration"].get<std::size_t>());
    for (const auto& entry : table["fields"][0]["tracks"][0]["frames"]) {
        for (auto frame = entry["frame"].get<std::size_t>(); frame < frames.size(); ++frame)
            frames[frame] = entry["data"][0]["values"][0];
    }
    return frames;
}

TEST(Xdts, BeginsWithTheBytesThatReadersTestFor) {
    EXPECT_TRUE(xdts(example(), 1, kOneTrack).starts_with("exchangeDigitalTimeSheet Save Data\n{"));
}

TEST(Xdts, ExpandsToTheScheduleFrameByFrame) {
    for (const int repeat : {1, 3}) {
        const Schedule schedule = example();
        const std::vector<std::string> frames = expanded(xdts(schedule, repeat, kOneTrack));
        ASSERT_EQ(frames.size(), static_cast<std::size_t>(repeat * 11));
        for (int frame = 0; frame < repeat * 11; ++frame) {
            EXPECT_EQ(frames[static_cast<std::size_t>(frame)], std::to_string(picture_at(schedule, frame) + 1))
                << frame;
        }
    }
}

TEST(Xdts, EndsWithAnEmptyCellAndNamesItsTrack) {
    const std::string text = xdts(example(), 1, kOneTrack);
    const auto json = nlohmann::json::parse(text.substr(text.find('\n') + 1));
    const auto& table = json["timeTables"][0];
    const auto& last = table["fields"][0]["tracks"][0]["frames"].back();
    EXPECT_EQ(last["frame"], 11);
    EXPECT_EQ(last["data"][0]["values"][0], "SYMBOL_NULL_CELL");
    EXPECT_EQ(table["timeTableHeaders"][0]["names"][0], "hair");
    EXPECT_EQ(json["version"], 5);
}

TEST(Xdts, EveryTrackHasItsNameAndTheSamePictures) {
    const std::vector<std::string> names{"hair", "前髪", "a \"b\""};
    const std::string text = xdts(example(), 2, names);
    const auto table = nlohmann::json::parse(text.substr(text.find('\n') + 1))["timeTables"][0];
    EXPECT_EQ(table["timeTableHeaders"][0]["names"], nlohmann::json(names));
    const auto& tracks = table["fields"][0]["tracks"];
    ASSERT_EQ(tracks.size(), 3U);
    for (std::size_t track = 0; track < 3; ++track) {
        EXPECT_EQ(tracks[track]["trackNo"], track);
        EXPECT_EQ(tracks[track]["frames"], tracks[0]["frames"]);
    }
}

TEST(Xdts, IsTheSameByteForByteForOneTrack) {
    Schedule schedule;
    schedule.frames = 3;
    schedule.pictures = 2;
    schedule.starts = {0, 2};
    schedule.holds = {2, 1};
    EXPECT_EQ(xdts(schedule, 1, kOneTrack),
              "exchangeDigitalTimeSheet Save Data\n"
              R"({"timeTables":[{"name":"hair","duration":3,"timeTableHeaders":[{"fieldId":0,"names":["hair"]}],)"
              R"("fields":[{"fieldId":0,"tracks":[{"trackNo":0,"frames":[)"
              R"({"frame":0,"data":[{"id":0,"values":["1"]}]},{"frame":2,"data":[{"id":0,"values":["2"]}]},)"
              R"({"frame":3,"data":[{"id":0,"values":["SYMBOL_NULL_CELL"]}]}]}]}]}],"version":5})");
}

}  // namespace
}  // namespace tuftwave::server::sheets
