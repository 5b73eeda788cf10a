#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "any_timing.hpp"
#include "sheets/csv.hpp"
#include "sheets/track_names.hpp"
#include "sheets/xdts.hpp"
#include "targets.hpp"

namespace tuftwave::server::fuzz {
namespace {

using nlohmann::json;

/// The cell on each frame, as readers expand a track: a value stays until the next entry.
std::vector<std::string> expanded(const json& track, const std::size_t duration) {
    std::vector<std::string> frames;
    std::string shown;
    for (const json& entry : track["frames"]) {
        frames.resize(std::min(duration, entry["frame"].get<std::size_t>()), shown);
        shown = entry["data"][0]["values"][0];
    }
    frames.resize(duration, shown);
    return frames;
}

void require_xdts(const std::string& text, const Schedule& schedule, const int repeat,
                  const std::vector<std::string>& names) {
    const std::size_t first_line = text.find('\n');
    require(text.substr(0, first_line) == "exchangeDigitalTimeSheet Save Data", "an XDTS has its first line");
    const json table = json::parse(text.substr(first_line + 1))["timeTables"][0];
    require(table["duration"] == repeat * schedule.frames, "the sheet has all frames");
    require(table["timeTableHeaders"][0]["names"] == json(names), "the tracks have their names");
    const json& tracks = table["fields"][0]["tracks"];
    require(tracks.size() == names.size(), "there is a track for each name");
    const auto duration = static_cast<std::size_t>(repeat * schedule.frames);
    const std::vector<std::string> frames = expanded(tracks.back(), duration);
    for (std::size_t frame = 0; frame < duration; ++frame)
        require(frames[frame] == std::to_string(picture_at(schedule, static_cast<int>(frame)) + 1),
                "each frame shows its picture");
    require(tracks.back()["frames"].back()["frame"] == duration, "the sheet ends with an empty cell");
}

void require_csv(const std::string& text, const Schedule& schedule, const int repeat) {
    std::string expected = "frame,picture,key\r\n";
    for (int frame = 0; frame < repeat * schedule.frames; ++frame) {
        const int picture = picture_at(schedule, frame);
        const bool is_key = schedule.starts[static_cast<std::size_t>(picture)] == frame % schedule.frames;
        expected += std::to_string(frame + 1) + "," + std::to_string(picture + 1) + (is_key ? ",1\r\n" : ",0\r\n");
    }
    require(text == expected, "a row for each frame");
}

}  // namespace

/// A timing, a number of cycles and names for the tracks; what is written is read back.
void run_sheets(const Target&, const std::string_view input) {
    ByteSource source(input);
    const Timing timing = any_timing(source);
    const Formulas formulas = source.byte() % 2 == 0 ? Formulas::kCorrected : Formulas::kAsPrinted;
    const int repeat = source.integer(1, 3);
    const Result<Schedule> schedule = make_schedule(timing, formulas, {});
    if (!schedule || schedule->frames > 120) return;  // a longer one says nothing new, and takes long to read
    std::vector<std::string> blocks(static_cast<std::size_t>(source.integer(1, 5)));
    for (std::string& block : blocks) block = source.text(12);
    const std::vector<std::string> names = sheets::track_names(blocks);
    require(!names.empty() && names.size() <= blocks.size(), "there is a track");
    require(std::set<std::string>(names.begin(), names.end()).size() == names.size(), "no two tracks have one name");
    require_xdts(sheets::xdts(*schedule, repeat, names), *schedule, repeat, names);
    require_csv(sheets::csv(*schedule, repeat), *schedule, repeat);
}

}  // namespace tuftwave::server::fuzz
