#include "sheets/xdts.hpp"

#include <nlohmann/json.hpp>

#include "sheets/track_names.hpp"

namespace tuftwave::server::sheets {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFirstLine = "exchangeDigitalTimeSheet Save Data\n";  // OpenToonz tests for exactly these bytes
constexpr const char* kCells = R"({"fieldId":0,)";

Json cell(int frame, const std::string& value) {
    return {{"frame", frame}, {"data", {{{"id", 0}, {"values", {value}}}}}};
}

Json cells(const Schedule& schedule, int repeat) {
    Json all = Json::array();
    for (int cycle = 0; cycle < repeat; ++cycle) {
        for (int n = 0; n < schedule.pictures; ++n) {
            all.push_back(
                cell(cycle * schedule.frames + schedule.starts[static_cast<std::size_t>(n)], std::to_string(n + 1)));
        }
    }
    all.push_back(cell(repeat * schedule.frames, "SYMBOL_NULL_CELL"));  // without it readers prolong the last picture
    return all;
}

}  // namespace

std::string xdts(const Schedule& schedule, int repeat, std::span<const std::string> tracks) {
    // All tracks have the same cells, and there can be many: they are put into words once.
    const std::string frames = R"(,"frames":)" + cells(schedule, repeat).dump() + "}";
    std::string text = kFirstLine + std::string(R"({"timeTables":[{"name":")") + kHairTrack + R"(","duration":)" +
                       std::to_string(repeat * schedule.frames) + R"(,"timeTableHeaders":[)" + kCells + R"("names":)" +
                       Json(std::vector<std::string>(tracks.begin(), tracks.end())).dump() + R"(}],"fields":[)" +
                       kCells + R"("tracks":[)";
    for (std::size_t track = 0; track < tracks.size(); ++track)
        text.append(track == 0 ? "" : ",").append(R"({"trackNo":)").append(std::to_string(track)).append(frames);
    return text + R"(]}]}],"version":5})";
}

}  // namespace tuftwave::server::sheets
