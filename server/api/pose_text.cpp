#include "api/pose_text.hpp"

#include <nlohmann/json.hpp>
#include <string_view>

#include "api/float_text.hpp"
#include "memory/buffers.hpp"
#include "memory/heap.hpp"

namespace tuftwave::server {
namespace {

constexpr std::size_t kMostDigits = 18;  // bytes of a number and the comma behind it
constexpr std::size_t kPoseBytes = 11 * kMostDigits + 3 * 3;
constexpr std::size_t kChainBytes = 64;                // of keys and brackets
constexpr std::size_t kLargeBytes = 32 * 1024 * 1024;  // beside which looking through the heap takes no time

template <std::size_t width>
void append_list(std::string& out, std::string_view key, std::span<const NodePose> poses,
                 std::array<float, width> NodePose::*part) {
    out.append(key);
    char mark = '[';
    for (const NodePose& pose : poses) {
        char text[width * (kFloatTextBytes + 1) + 3];
        char* end = text;
        *end++ = mark;
        for (std::size_t i = 0; i < width; ++i) {
            *end++ = i == 0 ? '[' : ',';
            end = write_float(end, (pose.*part)[i]);
        }
        *end++ = ']';
        out.append(text, end);
        mark = ',';
    }
    out += poses.empty() ? "[]" : "]";
}

void append_picture(std::string& out, std::span<const ChainPoses> chains, const std::vector<std::string>& names,
                    std::size_t picture) {
    out += "{\"chains\":[";
    for (std::size_t c = 0; c < chains.size(); ++c) {
        const ChainPoses& chain = chains[c];
        const auto poses = std::span(chain.poses).subspan(picture * chain.nodes, chain.nodes);
        out.append(c == 0 ? "{\"name\":" : ",{\"name\":").append(names[c]);
        append_list(out, ",\"rotations\":", poses, &NodePose::rotation);
        append_list(out, ",\"turns\":", poses, &NodePose::turn);
        append_list(out, ",\"positions\":", poses, &NodePose::position);
        out += '}';
    }
    out += "]}";
}

std::array<float, 4> to_floats(const Quat& q) {
    return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)};
}

}  // namespace

NodePose node_pose(const Quat& rotation, const Quat& turn, const Vec3& position) {
    return {to_floats(rotation),
            to_floats(turn),
            {static_cast<float>(position.x), static_cast<float>(position.y), static_cast<float>(position.z)}};
}

std::vector<ChainPoses> chain_poses(std::span<const Chain> chains, const HairMotion& motion,
                                    const std::stop_token& stop) {
    std::vector<ChainPoses> made(chains.size());
    for (std::size_t c = 0; c < chains.size() && !stop.stop_requested(); ++c) {
        const std::span<const Quat> rotations = motion.chains[c].rotations;
        const std::size_t nodes = chains[c].nodes.size();
        const std::vector<Quat> turns = model_turns(chains[c], rotations);
        made[c] = {chains[c].name, nodes, {}};
        made[c].poses.reserve(rotations.size());
        for (std::size_t first = 0; first < rotations.size(); first += nodes) {
            const std::vector<Vec3> positions = node_positions(chains[c], rotations.subspan(first, nodes));
            for (std::size_t i = 0; i < nodes; ++i)
                made[c].poses.push_back(node_pose(rotations[first + i], turns[first + i], positions[i]));
        }
    }
    return made;
}

std::string text_with_poses(const std::string& answer, std::span<const ChainPoses> chains, std::size_t pictures) {
    static constexpr std::string_view kPlace = "\"pictures\":null";  // in texts, quotes have backslashes
    const std::size_t at = answer.find(kPlace);
    if (at == std::string::npos) return answer;
    std::vector<std::string> names;
    std::size_t most = answer.size() + 16;
    for (const ChainPoses& chain : chains) {
        names.push_back(nlohmann::json(chain.name).dump());
        most += pictures * (names.back().size() + kChainBytes) + chain.poses.size() * kPoseBytes;
    }
    most += pictures * kChainBytes;
    memory::free_idle_buffers(std::chrono::seconds(0));  // what waits to be used again must not come on top of this
    if (most > kLargeBytes) memory::give_back_free_heap(std::chrono::seconds(0));  // nor what reading has left between
    std::string text;
    text.reserve(most);  // room that stays unused costs nothing, growing costs a copy
    text.append(answer, 0, at).append("\"pictures\":[");
    for (std::size_t n = 0; n < pictures; ++n) {
        if (n > 0) text += ',';
        append_picture(text, chains, names, n);
    }
    text += ']';
    text.append(answer, at + kPlace.size());
    return text;
}

}  // namespace tuftwave::server
