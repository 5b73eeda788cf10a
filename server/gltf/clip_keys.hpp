#pragma once

#include <cstddef>
#include <vector>

#include "tuftwave/schedule.hpp"

namespace tuftwave::server::gltf {

/// How a clip keeps a picture on show until the next one.
enum class Holding {
    kStep,     ///< glTF's own way: one key per picture
    kHeld,     ///< for importers that read every clip as linear: a second key just before the next picture
    kPerFrame  ///< for importers that take a key per frame, whatever lies between
};

/// What a clip moves: bones that vertices hang on, or which of the pictures' meshes is to be seen.
enum class ClipKind { kSkeleton, kFlipBook };

/// The keys of a clip, for whatever it moves.
struct ClipKeys {
    std::vector<float> times;           ///< seconds from 0, strictly increasing
    std::vector<std::size_t> pictures;  ///< what each key shows; the last one closes the loop with the first picture
    bool is_stepped = true;             ///< STEP, else LINEAR
};

/// Keys of one cycle. As key_times() says, those of a change are the largest float32 strictly below its frame's time.
ClipKeys clip_keys(const Schedule& schedule, Holding holding);

}  // namespace tuftwave::server::gltf
