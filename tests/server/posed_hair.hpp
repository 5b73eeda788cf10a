#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "poses/posed_hair.hpp"
#include "tuftwave/motion.hpp"

namespace tuftwave::server::poses {

/// Two chains of two bones and one, the second with rest rotations, moved at some frame rate.
struct SmallHair {
    explicit SmallHair(FrameRate fps = {24, 1}) {
        chains.push_back({"a", {{0, 1, 0}, {0, 0.5, 0}, {0, 0.25, 0.1}}, {{}, {}, {}}, {}, 0, {}, {}, "hair"});
        chains.push_back({"b", {{1, 0, 0}, {2, 0, 0}}, {{0, 1, 0, 0}, {}}, {0.6, 0, 0, 0.8}, 0, {}, {}, "hair"});
        Motion wave;
        wave.timing.fps = fps;
        motion.schedule = *make_schedule(wave.timing, Formulas::kCorrected, {});
        motion.chains = *move_chains(chains, wave, motion.schedule, {}, InOrder{}, {});
    }

    PosedHair posed() const { return {chains, motion, names}; }

    std::vector<Chain> chains;
    HairMotion motion;
    BoneNames names{{"a_01", "a_02"}, {"b_01"}};
};

}  // namespace tuftwave::server::poses
