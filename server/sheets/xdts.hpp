#pragma once

#include <span>
#include <string>

#include "tuftwave/schedule.hpp"

namespace tuftwave::server::sheets {

/// The exposure sheet as XDTS (exchange digital time sheet, version 5), which OpenToonz, CLIP STUDIO PAINT, TVPaint and
/// Toei's digital time sheet read. Pictures are numbered from 1. XDTS stores no frame rate.
/// @param repeat  cycles written out, >= 1
/// @param tracks  at least one, as track_names() makes them, bottom layer first; all have the same pictures
std::string xdts(const Schedule& schedule, int repeat, std::span<const std::string> tracks);

}  // namespace tuftwave::server::sheets
