#include <bit>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "any_timing.hpp"
#include "poses/bvh.hpp"
#include "poses/code_page_932.hpp"
#include "poses/usda.hpp"
#include "poses/vmd.hpp"
#include "targets.hpp"
#include "tuftwave/motion.hpp"

namespace tuftwave::server::fuzz {
namespace {

constexpr std::size_t kHead = 54, kKey = 111, kNameBytes = 15;
constexpr double kTolerance = 1e-5;  // of a quaternion's length: float32 keeps seven digits

std::uint32_t word_at(const std::string& bytes, const std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes.at(at + i));
    return word;
}

Vec3 any_point(ByteSource& source) { return {source.number(-1, 1), source.number(-1, 1), source.number(-1, 1)}; }

Chain any_chain(ByteSource& source) {
    Chain chain;
    chain.name = source.text(8);
    chain.nodes.resize(static_cast<std::size_t>(source.integer(2, 5)));
    for (Vec3& node : chain.nodes) node = any_point(source);
    chain.rest_rotations.resize(chain.nodes.size());
    const Vec3 axis = any_point(source);
    chain.parent_rotation = {axis.x, axis.y, axis.z, source.number(-1, 1)};
    return chain;
}

/// A name for each bone, no two alike, some of them no UTF-8.
poses::BoneNames any_names(ByteSource& source, const std::vector<Chain>& chains, const bool is_utf8) {
    poses::BoneNames names;
    std::set<std::string> used;
    for (const Chain& chain : chains) {
        std::vector<std::string>& bones = names.emplace_back();
        while (bones.size() + 1 < chain.nodes.size()) {
            std::string name = is_utf8 ? source.text(10) : source.raw(20);
            while (!used.insert(name).second) name += std::to_string(used.size());
            bones.push_back(name);
        }
    }
    return names;
}

/// A bone's key: its name and frame, and a rotation that turns and nothing else.
void require_key(const std::string& bytes, const std::size_t at, const std::string& name, const int frame) {
    const std::string field = bytes.substr(at, kNameBytes);
    require(field == name + std::string(kNameBytes - name.size(), '\0'), "a key has its bone's name");
    require(word_at(bytes, at + kNameBytes) == static_cast<std::uint32_t>(frame), "a key has its frame");
    double square = 0;
    for (std::size_t i = 0; i < 7; ++i) {
        const double value = static_cast<double>(std::bit_cast<float>(word_at(bytes, at + kNameBytes + 4 + 4 * i)));
        require(i >= 3 || value == 0, "a bone keeps its place");
        square += value * value;
    }
    require(std::abs(std::sqrt(square) - 1) < kTolerance, "a rotation has length 1");
}

void require_vmd(const poses::PosedHair& hair, const int repeat) {
    const Result<std::string> made = poses::vmd(hair, repeat);
    bool fits = true;
    std::vector<std::string> names;
    for (const std::vector<std::string>& bones : hair.names) {
        for (const std::string& bone : bones) {
            const auto encoded = poses::to_code_page_932(bone);
            fits = fits && encoded && !encoded->empty() && encoded->size() <= kNameBytes;
            names.push_back(encoded.value_or(""));
        }
    }
    require(static_cast<bool>(made) == fits, "a VMD is refused for names and for nothing else");
    if (!made) return;
    const std::vector<poses::VmdKey> keys = poses::vmd_keys(hair.motion.schedule, repeat);
    require(word_at(*made, kHead - 4) == names.size() * keys.size(), "every bone has every key");
    require(made->size() == kHead + kKey * names.size() * keys.size() + 20, "a VMD has its size");
    for (std::size_t i = 0; i < names.size() * keys.size(); ++i)
        require_key(*made, kHead + kKey * i, names[i / keys.size()], keys[i % keys.size()].frame);
}

std::size_t count(const std::string& text, const std::string_view part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
    return found;
}

void require_bvh(const poses::PosedHair& hair) {
    const std::string text = poses::bvh(hair);
    std::size_t bones = 0;
    for (const auto& names : hair.names) bones += names.size();
    require(count(text, "JOINT ") >= bones, "every bone is a joint");
    require(count(text, "{\n") == count(text, "}\n"), "braces come in pairs");
    const std::size_t motion = text.rfind("Frame Time:");
    require(motion != std::string::npos, "there is a motion");
    require(count(text.substr(motion), "\n") == 1 + static_cast<std::size_t>(hair.motion.schedule.frames),
            "there is a line for each frame");
    require(text.find("nan", motion) == std::string::npos && text.find("inf", motion) == std::string::npos,
            "angles are numbers");
}

void require_usda(const poses::PosedHair& hair) {
    const std::string text = poses::usda(hair);
    require(text.starts_with("#usda 1.0\n"), "a USD has its first line");
    for (const std::string_view pair : {"{}", "[]", "()"})
        require(count(text, pair.substr(0, 1)) == count(text, pair.substr(1)), "brackets come in pairs");
}

}  // namespace

/// Chains, a wave, a schedule and names for the bones; what is written is read back.
void run_poses(const Target&, const std::string_view input) {
    ByteSource source(input);
    Motion motion;
    motion.timing = any_timing(source, poses::kVmdRate.numerator);
    motion.wave.amplitude = source.number(-2, 2);
    motion.wind = any_point(source);
    const bool is_utf8 = source.byte() % 4 != 0;
    const int repeat = source.integer(1, 3);
    const Result<Schedule> schedule = make_schedule(motion.timing, Formulas::kCorrected, {});
    if (!schedule || schedule->frames > 60) return;
    std::vector<Chain> chains(static_cast<std::size_t>(source.integer(1, 3)));
    for (Chain& chain : chains) chain = any_chain(source);
    if (check_chains(chains, {})) return;
    const auto moved = move_chains(chains, motion, *schedule, {}, InOrder(), {});
    if (!moved) return;
    const HairMotion posed{*schedule, *moved};
    const poses::BoneNames names = any_names(source, chains, is_utf8);
    require_vmd({chains, posed, names}, repeat);
    if (!is_utf8) return;  // the others are only ever given what was read as JSON
    require_bvh({chains, posed, names});
    require_usda({chains, posed, names});
}

}  // namespace tuftwave::server::fuzz
