#include "work.hpp"

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "measure.hpp"
#include "memory/buffers.hpp"

namespace tuftwave::bench {
namespace {

template <class Value>
Value value_of(Result<Value> result) {
    if (!result) throw std::runtime_error(result.error().field + ": " + result.error().allowed);
    return std::move(result).value();
}

}  // namespace

Hairstyle hair_of(const Workloads& workloads, std::size_t strokes) {
    Hairstyle hairstyle;
    for (std::size_t i = 0; i < strokes; ++i) {
        Tuft& tuft = hairstyle.tufts.emplace_back();
        for (const Point& point : workloads.strokes[i % workloads.strokes.size()])
            tuft.points.push_back({point[0], point[1], point[2]});
    }
    hairstyle.mesh.rings = 64;
    hairstyle.mesh.sides = 12;
    hairstyle.mesh.skin = false;
    return hairstyle;
}

server::gltf::Look merged_look() {
    server::gltf::Look look;
    look.layout = server::gltf::Layout::kMerged;
    return look;
}

Limits no_limits() {
    Limits limits;
    constexpr std::size_t kAny = std::numeric_limits<std::uint32_t>::max();
    limits.tufts = limits.chains = limits.points = limits.joints = limits.vertices = limits.triangles = kAny;
    return limits;
}

server::gltf::File hair_glb(const Hairstyle& hairstyle, const server::gltf::Look& look, const ForEach& for_each,
                            server::gltf::Compression compression) {
    const HairPlan plan = value_of(plan_hairstyle(hairstyle, no_limits(), for_each, {}));
    return server::gltf::hair_file(plan, look, "{}", {nlohmann::json()}, server::gltf::Container::kGlb, compression,
                                   for_each, {});
}

void sent(server::gltf::File file) {
    keep(file.memory.data());
    server::memory::give_back(std::move(file.memory));
}

std::vector<Chain> chains_of(const Workloads& workloads) {
    std::vector<Chain> chains;
    for (const Line& line : workloads.chains) {
        Chain& chain = chains.emplace_back();
        chain.name = "lock_" + std::to_string(chains.size() - 1);
        for (const Point& point : line) chain.nodes.push_back({point[0], point[1], point[2]});
        chain.rest_rotations.resize(chain.nodes.size());
    }
    return chains;
}

Motion motion_of(int hold) {
    Motion motion;
    motion.timing.period = 1;
    motion.timing.hold = hold;
    return motion;
}

HairMotion moved(const std::vector<Chain>& chains, const Motion& motion) {
    const Limits limits;
    Schedule schedule = value_of(make_schedule(motion.timing, Formulas::kCorrected, limits));
    auto rotations = value_of(move_chains(chains, motion, schedule, limits, InOrder(), {}));
    return {std::move(schedule), std::move(rotations)};
}

}  // namespace tuftwave::bench
