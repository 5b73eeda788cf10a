// Requests and poses by nlohmann-json alone: parsed into a document, built as one and dumped.
//
//   tuftwave_bench_json FOLDER      with w1.json and w2.json
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/pose_text.hpp"
#include "api/write_nouns.hpp"
#include "measure.hpp"
#include "ours/work.hpp"

namespace {

using namespace tuftwave;
using namespace tuftwave::bench;
using Json = nlohmann::json;

/// A chain's numbers in one picture, as short as ours, so that both write the same digits.
struct Numbers {
    std::string name;
    std::vector<std::array<double, 4>> rotations, turns;
    std::vector<std::array<double, 3>> positions;
};

template <std::size_t width>
std::array<double, width> shortened(const std::array<float, width>& floats) {
    std::array<double, width> values{};
    for (std::size_t i = 0; i < width; ++i) values[i] = server::short_number(static_cast<double>(floats[i]));
    return values;
}

std::vector<std::vector<Numbers>> pictures_of(const std::vector<server::ChainPoses>& chains, std::size_t count) {
    std::vector<std::vector<Numbers>> pictures(count);
    for (std::size_t n = 0; n < count; ++n) {
        for (const server::ChainPoses& chain : chains) {
            Numbers& numbers = pictures[n].emplace_back();
            numbers.name = chain.name;
            for (std::size_t i = 0; i < chain.nodes; ++i) {
                const server::NodePose& pose = chain.poses[n * chain.nodes + i];
                numbers.rotations.push_back(shortened(pose.rotation));
                numbers.turns.push_back(shortened(pose.turn));
                numbers.positions.push_back(shortened(pose.position));
            }
        }
    }
    return pictures;
}

std::string text_of(const std::vector<std::vector<Numbers>>& pictures) {
    Json list = Json::array();
    for (const std::vector<Numbers>& picture : pictures) {
        Json chains = Json::array();
        for (const Numbers& chain : picture) {
            chains.push_back({{"name", chain.name},
                              {"rotations", chain.rotations},
                              {"turns", chain.turns},
                              {"positions", chain.positions}});
        }
        list.push_back({{"chains", std::move(chains)}});
    }
    return Json{{"pictures", std::move(list)}}.dump();
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return std::fputs("usage: tuftwave_bench_json FOLDER\n", stderr), 2;
    const Workloads workloads = read_workloads(arguments[1]);
    measure("read/nlohmann", [&] { keep(Json::parse(workloads.strokes_text)); });
    const std::vector<Chain> chains = chains_of(workloads);
    const HairMotion motion = moved(chains, motion_of(2));
    const auto pictures = pictures_of(server::chain_poses(chains, motion, {}), motion.schedule.starts.size());
    measure("pose_text/nlohmann", [&] { keep(text_of(pictures)); });
    print_value("pose_text_bytes/nlohmann", static_cast<double>(text_of(pictures).size()), "B");
}
