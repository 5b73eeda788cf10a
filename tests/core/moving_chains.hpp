#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tuftwave/motion.hpp"

/// Small chains, and what a motion does to them.
namespace tuftwave::test {

inline constexpr std::size_t kPictures = 6;  // of the default timing

inline Schedule schedule_of(const Timing& timing = {}) { return *make_schedule(timing, Formulas::kCorrected, {}); }

inline Chain chain_of(std::vector<Vec3> nodes) {
    Chain chain;
    chain.rest_rotations.resize(nodes.size());
    chain.nodes = std::move(nodes);
    return chain;
}

inline Chain straight(const Vec3& direction, const int bones) {
    std::vector<Vec3> nodes;
    for (int i = 0; i <= bones; ++i) nodes.push_back(Vec3{0.1, 0.2, 0.3} + (0.3 * i / bones) * direction);
    return chain_of(nodes);
}

/// Hair as it hangs, its bones unequal.
inline Chain hanging() {
    return chain_of(
        {{0.05, 0.1, 0}, {0.07, 0.05, 0.01}, {0.075, -0.02, 0.03}, {0.07, -0.06, 0.03}, {0.06, -0.16, 0.02}});
}

/// The same chain, its rest rotations anything at all.
inline Chain with_rest_rotations(Chain chain, const std::function<Quat()>& next) {
    chain.parent_rotation = next();
    for (Quat& rotation : chain.rest_rotations) rotation = next();
    return chain;
}

inline ChainMotion moved(const Chain& chain, const Motion& motion) {
    const auto result = move_chains(std::span(&chain, 1), motion, schedule_of(motion.timing), {}, InOrder{}, {});
    EXPECT_TRUE(result) << (result ? "" : result.error().field);
    return result ? (*result)[0] : ChainMotion{};
}

/// The chain's nodes in each picture.
inline std::vector<std::vector<Vec3>> pictures(const Chain& chain, const Motion& motion) {
    const ChainMotion all = moved(chain, motion);
    const std::size_t nodes = chain.nodes.size();
    std::vector<std::vector<Vec3>> result;
    for (std::size_t at = 0; at < all.rotations.size(); at += nodes) {
        result.push_back(node_positions(chain, std::span(all.rotations).subspan(at, nodes)));
    }
    return result;
}

inline Motion motion_in(const Mode mode, const std::optional<Droop> droop = {}) {
    Motion motion;
    motion.mode = mode;
    motion.droop = droop;
    return motion;
}

/// Every way of laying a wave on a chain.
inline std::vector<Motion> all_motions() {
    std::vector<Motion> motions;
    for (const Mode mode : {Mode::kRelative, Mode::kAbsolute}) {
        for (const Droop droop : {Droop::kKeep, Droop::kRemove}) {
            for (const double lift : {0.0, 0.3, 1.0}) {
                motions.push_back(motion_in(mode, droop));
                motions.back().lift = lift;
            }
        }
    }
    motions.push_back({});
    motions.back().one_sided = true;
    return motions;
}

inline Chain with_outward(Chain chain) {
    chain.outward = Vec3{1, 0, 0};
    return chain;
}

}  // namespace tuftwave::test
