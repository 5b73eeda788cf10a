#pragma once

#include <span>
#include <string>
#include <vector>

namespace tuftwave::server::sheets {

/// The track of whatever is not said to be drawn in a block of its own.
inline constexpr const char* kHairTrack = "hair";

/// A sheet's tracks: each block once, in the order in which they first appear. Readers trim names and merge those that
/// are then the same, so names are trimmed here; of a blank one nothing is left, and it is called kHairTrack.
std::vector<std::string> track_names(std::span<const std::string> blocks);

}  // namespace tuftwave::server::sheets
