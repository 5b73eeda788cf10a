#pragma once

#include <string>

#include "poses/posed_hair.hpp"

namespace tuftwave::server::poses {

/// One cycle as USD text: a SkelRoot with a Skeleton and its SkelAnimation, no mesh. Metres, Y up; a time code is a
/// frame. USD cannot state that a picture is held, so each has two samples, at its first frame and a thousandth of a
/// frame before the next picture; the first picture once more, at the end of the cycle, closes the loop. Names are made
/// of ASCII letters, digits and underscores.
std::string usda(const PosedHair& hair);

}  // namespace tuftwave::server::poses
