#pragma once

#include <string>

#include "tuftwave/schedule.hpp"

namespace tuftwave::server::sheets {

/// The exposure sheet as XDTS (exchange digital time sheet, version 5), which OpenToonz, CLIP STUDIO PAINT, TVPaint and
/// Toei's digital time sheet read. One track named "hair"; pictures are numbered from 1. XDTS stores no frame rate.
/// @param repeat  cycles written out, >= 1
std::string xdts(const Schedule& schedule, int repeat);

}  // namespace tuftwave::server::sheets
