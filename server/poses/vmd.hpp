#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "poses/posed_hair.hpp"
#include "tuftwave/result.hpp"

namespace tuftwave::server::poses {

/// Frames per second of every VMD; motions for one must be made at this rate.
inline constexpr FrameRate kVmdRate{30, 1};

/// A key of a bone: the same pictures for all of them.
struct VmdKey {
    int frame, picture;
    bool is_change;  ///< whether another picture comes before it, so that what lies between must not be seen
};

/// The keys of each bone. VMD knows no steps, so a picture has a key at its first frame and, when it is held, an equal
/// one at its last; the first picture once more closes the last cycle.
/// @param repeat  cycles, >= 1
std::vector<VmdKey> vmd_keys(const Schedule& schedule, int repeat);

/// A motion for MikuMikuDance, with physics switched off on every bone it turns, since MMD would else ignore it.
/// The axes are MMD's: left-handed, the model faces -Z.
/// @param hair  made at kVmdRate
/// @errors  conflict at "/<chain>", where a bone's name has no code or more than 15 bytes in code page 932
Result<std::string> vmd(const PosedHair& hair, int repeat);

}  // namespace tuftwave::server::poses
