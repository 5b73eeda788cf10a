#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server {

// From core's structs to JSON. Defaults are written out, so that a hairstyle reads back to the same one even if a
// default should change; what is unset stays out.

nlohmann::ordered_json tuft_json(const Tuft& tuft);
nlohmann::ordered_json fill_report_json(const FillReport& report);
nlohmann::ordered_json wave_json(const Wave& wave);
nlohmann::ordered_json schedule_json(const Schedule& schedule);

/// What an animator would check; incomplete once `stop` is set.
nlohmann::ordered_json quality_json(std::span<const Chain> chains, const Wave& wave, const HairMotion& motion,
                                    const std::stop_token& stop);

/// What a caller should be told although there is an answer.
nlohmann::ordered_json warnings_json(const Schedule* schedule, std::span<const FillReport> fills = {});

/// A number of a pose: the shortest decimal that reads back to the same float32.
double short_number(double value);
nlohmann::ordered_json pose_json(const Vec3& v);
nlohmann::ordered_json pose_json(const Quat& q);

/// "24" or "24000/1001".
std::string frame_rate_text(const FrameRate& fps);

/// What a decimal can say exactly as a number, else a text, since a fraction might have more digits than we read.
nlohmann::ordered_json frame_rate_json(const FrameRate& fps);

}  // namespace tuftwave::server
