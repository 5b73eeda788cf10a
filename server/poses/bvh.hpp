#pragma once

#include <string>

#include "poses/posed_hair.hpp"

namespace tuftwave::server::poses {

/// One cycle as BVH: every chain below one root at the model's origin, a line per frame. Metres, Y up; angles in
/// degrees, Zrotation Xrotation Yrotation. A loop has as many lines as frames: the line after the last one is the
/// first. Names lose blanks and braces.
std::string bvh(const PosedHair& hair);

}  // namespace tuftwave::server::poses
