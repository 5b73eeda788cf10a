// W2 and W3: clips, poses as text, and what is only computed.
#include <nlohmann/json.hpp>

#include "api/pose_text.hpp"
#include "gltf/hair_file.hpp"
#include "measure.hpp"
#include "work.hpp"

namespace tuftwave::bench {
namespace {

constexpr int kOnOnes = 1, kOnTwos = 2;

server::gltf::File clip(const std::vector<Chain>& chains, const Motion& motion) {
    return server::gltf::clip_file(chains, moved(chains, motion), "{}", {nlohmann::json::object()},
                                   server::gltf::Container::kGlb);
}

}  // namespace

void measure_motion(const Workloads& workloads) {
    const std::vector<Chain> chains = chains_of(workloads);
    const Motion twos = motion_of(kOnTwos), ones = motion_of(kOnOnes);
    measure("w2/tuftwave", [&] { sent(clip(chains, twos)); });
    measure("w3/tuftwave", [&] { sent(clip(chains, ones)); });
    measure("evaluation/tuftwave", [&] { keep(moved(chains, twos)); });

    const HairMotion motion = moved(chains, twos);
    const auto poses = server::chain_poses(chains, motion, {});
    const auto pictures = static_cast<std::size_t>(motion.schedule.pictures);
    const nlohmann::ordered_json frame{{"pictures", nullptr}};
    measure("pose_text/tuftwave", [&] { sent({server::text_with_poses(frame.dump(), poses, pictures)}); });
    print_value("pose_text_bytes/tuftwave",
                static_cast<double>(server::text_with_poses(frame.dump(), poses, pictures).size()), "B");
    print_value("w2_bytes/tuftwave", static_cast<double>(clip(chains, twos).bytes().size()), "B");
}

}  // namespace tuftwave::bench
