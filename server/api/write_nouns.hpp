#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "gltf/hair_file.hpp"
#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server {

// From core's structs to JSON. What a request could have left out and did stays out, so that a hairstyle reads back to
// the same one.

nlohmann::ordered_json hairstyle_json(const Hairstyle& hairstyle, const gltf::Look& look);
nlohmann::ordered_json schedule_json(const Schedule& schedule);

/// Every chain's rotations and positions, picture by picture.
nlohmann::ordered_json pictures_json(std::span<const Chain> chains, const HairMotion& motion);
nlohmann::ordered_json quality_json(std::span<const Chain> chains, const Wave& wave, const HairMotion& motion);

/// What a caller should be told although there is an answer.
nlohmann::ordered_json warnings_json(const Schedule* schedule);

/// "24" or "24000/1001".
std::string frame_rate_text(const FrameRate& fps);

}  // namespace tuftwave::server
