#pragma once

#include <string>

#include "tuftwave/schedule.hpp"

namespace tuftwave::server::sheets {

/// The exposure sheet as CSV (RFC 4180): a row per frame with the frame (from 1), the picture on show (from 1), and 1
/// where the drawing changes.
/// @param repeat  cycles written out, >= 1
std::string csv(const Schedule& schedule, int repeat);

}  // namespace tuftwave::server::sheets
