#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server {

/// What an answer says of a node in a picture. Floats, since answers have no more digits.
struct NodePose {
    std::array<float, 4> rotation, turn;  ///< x y z w
    std::array<float, 3> position;
};

/// A chain in all pictures.
struct ChainPoses {
    std::string name;
    std::size_t nodes = 0;
    std::vector<NodePose> poses;  ///< picture n, node i is at n * nodes + i
};

NodePose node_pose(const Quat& rotation, const Quat& turn, const Vec3& position);

/// The poses of chains that hang on nothing. Incomplete once `stop` is set.
std::vector<ChainPoses> chain_poses(std::span<const Chain> chains, const HairMotion& motion,
                                    const std::stop_token& stop);

/// The text of an answer whose member "pictures" is null, with the poses in its place. They would be ten times as large
/// as JSON values, half a million nodes 600 MiB.
/// @param answer  text, since its values may be many, too; no other member of that name is null
std::string text_with_poses(const std::string& answer, std::span<const ChainPoses> chains, std::size_t pictures);

}  // namespace tuftwave::server
