#include "sheets/csv.hpp"

namespace tuftwave::server::sheets {

std::string csv(const Schedule& schedule, int repeat) {
    std::string rows = "frame,picture,key\r\n";
    for (int frame = 0; frame < repeat * schedule.frames; ++frame) {
        const int picture = picture_at(schedule, frame);
        const bool is_key = schedule.starts[static_cast<std::size_t>(picture)] == frame % schedule.frames;
        rows += std::to_string(frame + 1) + "," + std::to_string(picture + 1) + (is_key ? ",1\r\n" : ",0\r\n");
    }
    return rows;
}

}  // namespace tuftwave::server::sheets
