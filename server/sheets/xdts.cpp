#include "sheets/xdts.hpp"

#include <nlohmann/json.hpp>

namespace tuftwave::server::sheets {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFirstLine = "exchangeDigitalTimeSheet Save Data\n";  // OpenToonz tests for exactly these bytes
constexpr const char* kTrackName = "hair";
constexpr int kCells = 0;  // fieldId

Json cell(int frame, const std::string& value) {
    return {{"frame", frame}, {"data", {{{"id", 0}, {"values", {value}}}}}};
}

}  // namespace

std::string xdts(const Schedule& schedule, int repeat) {
    Json cells = Json::array();
    for (int cycle = 0; cycle < repeat; ++cycle) {
        for (int n = 0; n < schedule.pictures; ++n) {
            cells.push_back(
                cell(cycle * schedule.frames + schedule.starts[static_cast<std::size_t>(n)], std::to_string(n + 1)));
        }
    }
    const int duration = repeat * schedule.frames;
    cells.push_back(cell(duration, "SYMBOL_NULL_CELL"));  // without it readers prolong the last picture
    const Json track{{"trackNo", 0}, {"frames", std::move(cells)}};
    const Json table{{"name", kTrackName},
                     {"duration", duration},
                     {"timeTableHeaders", Json::array({{{"fieldId", kCells}, {"names", Json::array({kTrackName})}}})},
                     {"fields", Json::array({{{"fieldId", kCells}, {"tracks", Json::array({track})}}})}};
    return kFirstLine + Json{{"timeTables", Json::array({table})}, {"version", 5}}.dump();
}

}  // namespace tuftwave::server::sheets
