// How fast motion and what is written of it are: W2, 200 chains of 16 nodes in 12 pictures. Nothing asserts a time.
#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "api/pose_text.hpp"
#include "api/write_nouns.hpp"
#include "gltf/hair_file.hpp"
#include "tuftwave/elementary.hpp"
#include "tuftwave/motion.hpp"

namespace tuftwave::server {
namespace {

constexpr std::size_t kNodePoses = std::size_t{200} * 16 * 12;

/// Hanging all around, all different.
std::vector<Chain> chains_of_w2() {
    std::vector<Chain> chains;
    for (int c = 0; c < 200; ++c) {
        const auto around = elementary::sincos(2.399963 * c);  // the golden angle
        Chain chain;
        for (int i = 0; i < 16; ++i) {
            const double down = 0.014 * i, out = 0.09 + 0.0001 * (c % 97) + 0.1 * down - 0.2 * down * down;
            chain.nodes.push_back({out * around.sin, 0.1 - down, out * around.cos});
        }
        chain.name = "lock " + std::to_string(c);
        chain.rest_rotations.resize(chain.nodes.size());
        chains.push_back(std::move(chain));
    }
    return chains;
}

Schedule schedule_of_w2() { return *make_schedule({1, {24, 1}, 2, ShortHolds::kLast, Sampling::kUniform}, {}, {}); }

HairMotion motion_of_w2(const std::vector<Chain>& chains, double tip_exponent = 1) {
    Motion motion;
    motion.wave.tip_exponent = tip_exponent;
    const Schedule schedule = schedule_of_w2();
    return {schedule, *move_chains(chains, motion, schedule, {}, InOrder(), {})};
}

void count_node_poses(benchmark::State& state) {
    state.counters["node-poses/s"] =
        benchmark::Counter(static_cast<double>(kNodePoses), benchmark::Counter::kIsIterationInvariantRate);
}

void move_w2(benchmark::State& state, double tip_exponent) {
    const std::vector<Chain> chains = chains_of_w2();
    for (auto _ : state) benchmark::DoNotOptimize(motion_of_w2(chains, tip_exponent));
    count_node_poses(state);
}
BENCHMARK_CAPTURE(move_w2, straight_envelope, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(move_w2, curved_envelope, 1.7)->Unit(benchmark::kMillisecond);

gltf::File clip_of(const std::vector<Chain>& chains, const HairMotion& motion) {
    return gltf::clip_file(chains, motion, "{}", {nlohmann::json::object()}, gltf::Container::kGlb);
}

/// From chains to a GLB in memory.
void clip_w2(benchmark::State& state) {
    const std::vector<Chain> chains = chains_of_w2();
    for (auto _ : state) benchmark::DoNotOptimize(clip_of(chains, motion_of_w2(chains)));
    count_node_poses(state);
}
BENCHMARK(clip_w2)->Unit(benchmark::kMillisecond);

void write_clip_w2(benchmark::State& state) {
    const std::vector<Chain> chains = chains_of_w2();
    const HairMotion motion = motion_of_w2(chains);
    for (auto _ : state) benchmark::DoNotOptimize(clip_of(chains, motion));
    state.counters["us/joint"] = benchmark::Counter(
        200.0 * 15 / 1e6, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(write_clip_w2)->Unit(benchmark::kMillisecond);

/// What POST /v1/motions answers, but for its report.
void pose_text_w2(benchmark::State& state) {
    const std::vector<Chain> chains = chains_of_w2();
    const HairMotion motion = motion_of_w2(chains);
    const nlohmann::ordered_json frame{{"pictures", nullptr}};
    for (auto _ : state) {
        const std::vector<ChainPoses> poses = chain_poses(chains, motion, {});
        benchmark::DoNotOptimize(text_with_poses(frame.dump(), poses, 12));
    }
    count_node_poses(state);
}
BENCHMARK(pose_text_w2)->Unit(benchmark::kMillisecond);

/// The same document by the library's values, to compare with.
void nlohmann_poses_w2(benchmark::State& state) {
    const std::vector<Chain> chains = chains_of_w2();
    const HairMotion motion = motion_of_w2(chains);
    const std::vector<ChainPoses> numbers = chain_poses(chains, motion, {});
    std::vector<std::vector<std::array<double, 11>>> shortened;  // as they stand in the text
    for (const ChainPoses& chain : numbers) {
        for (auto& into = shortened.emplace_back(); const NodePose& pose : chain.poses) {
            double* to = into.emplace_back().data();
            for (const float part : pose.rotation) *to++ = short_number(static_cast<double>(part));
            for (const float part : pose.turn) *to++ = short_number(static_cast<double>(part));
            for (const float part : pose.position) *to++ = short_number(static_cast<double>(part));
        }
    }
    const auto array = [](const double* from, std::size_t count) {
        nlohmann::json made = nlohmann::json::array();
        for (std::size_t i = 0; i < count; ++i) made.push_back(from[i]);
        return made;
    };
    for (auto _ : state) {
        nlohmann::json document{{"pictures", nlohmann::json::array()}};
        for (std::size_t n = 0; n < 12; ++n) {
            nlohmann::json picture{{"chains", nlohmann::json::array()}};
            for (std::size_t c = 0; c < numbers.size(); ++c) {
                const ChainPoses& chain = numbers[c];
                nlohmann::json rotations = nlohmann::json::array(), turns = rotations, positions = rotations;
                for (std::size_t i = n * chain.nodes; i < (n + 1) * chain.nodes; ++i) {
                    rotations.push_back(array(&shortened[c][i][0], 4));
                    turns.push_back(array(&shortened[c][i][4], 4));
                    positions.push_back(array(&shortened[c][i][8], 3));
                }
                picture["chains"].push_back({{"name", chain.name},
                                             {"rotations", std::move(rotations)},
                                             {"turns", std::move(turns)},
                                             {"positions", std::move(positions)}});
            }
            document["pictures"].push_back(std::move(picture));
        }
        benchmark::DoNotOptimize(document.dump());
    }
    count_node_poses(state);
}
BENCHMARK(nlohmann_poses_w2)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tuftwave::server
