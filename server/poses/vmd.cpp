// Based on: what three independent readers of the format agree on; there is no specification.
#include "poses/vmd.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

#include "poses/code_page_932.hpp"

namespace tuftwave::server::poses {
namespace {

constexpr std::size_t kSignatureBytes = 30, kModelNameBytes = 20, kBoneNameBytes = 15, kKeyBytes = 111;
constexpr std::size_t kOtherSections = 5;  // faces, cameras, lights, shadows, visibility: none of them, but counted

using Curve = std::array<std::uint8_t, 4>;  // x1, y1, x2, y2 of a Bezier curve from (0, 0) to (127, 127)
constexpr Curve kLinear{20, 20, 107, 107};
constexpr Curve kLate{127, 0, 127, 0};  // halfway through only 0.9 % of the change is to be seen

void append_word(std::string& out, std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<char>(word >> shift & 0xff));
}

void append_float(std::string& out, double value) {
    append_word(out, std::bit_cast<std::uint32_t>(static_cast<float>(value) + 0.0F));
}

void append_padded(std::string& out, std::string_view text, std::size_t bytes) {
    out.append(text.substr(0, bytes)).append(bytes - std::min(text.size(), bytes), '\0');
}

/// The 64 bytes that shape the segment which ends at a key, the same for all four of its curves: a row of 16 bytes, and
/// the row again with 1, 2 and 3 bytes less at its front. The first row's bytes 2 and 3 say that physics is off.
std::string interpolation(const Curve& curve) {
    std::string row;
    for (const std::uint8_t part : curve) row.append(4, static_cast<char>(part));
    std::string bytes;
    for (std::size_t less = 0; less < 4; ++less) append_padded(bytes, std::string_view(row).substr(less), row.size());
    bytes[2] = '\x63';
    bytes[3] = '\x0f';
    return bytes;
}

Error unfit_name(std::size_t chain, const std::string& name) {
    return {ErrorCode::kConflict,
            "/" + std::to_string(chain),
            name,
            "bones' names of at most 15 bytes in code page 932, which is what a VMD has room for",
            {},
            {}};
}

class VmdWriter {
  public:
    VmdWriter(const PosedHair& hair, int repeat)
        : hair_(hair),
          keys_(vmd_keys(hair.motion.schedule, repeat)),
          linear_(interpolation(kLinear)),
          late_(interpolation(kLate)) {}

    Result<std::string> write() {
        std::size_t bones = 0;
        for (const Chain& chain : hair_.chains) bones += chain.nodes.size() - 1;
        out_.reserve(kSignatureBytes + kModelNameBytes + 4 * (1 + kOtherSections) + bones * keys_.size() * kKeyBytes);
        append_padded(out_, "Vocaloid Motion Data 0002", kSignatureBytes);
        append_padded(out_, "hair", kModelNameBytes);
        append_word(out_, static_cast<std::uint32_t>(bones * keys_.size()));
        for (std::size_t c = 0; c < hair_.chains.size(); ++c) {
            if (Check wrong = append_chain(c)) return *wrong;
        }
        for (std::size_t section = 0; section < kOtherSections; ++section) append_word(out_, 0);
        return std::move(out_);
    }

  private:
    Check append_chain(std::size_t c) {
        const std::vector<Quat> turns = bone_turns(hair_.chains[c], hair_.motion.chains[c].rotations);
        const std::size_t nodes = hair_.chains[c].nodes.size();
        for (std::size_t i = 0; i + 1 < nodes; ++i) {
            const std::string& name = hair_.names[c][i];
            const auto encoded = to_code_page_932(name);
            if (!encoded || encoded->empty() || encoded->size() > kBoneNameBytes) return unfit_name(c, name);
            for (const VmdKey& key : keys_)
                append_key(*encoded, key, turns[static_cast<std::size_t>(key.picture) * nodes + i]);
        }
        return {};
    }

    void append_key(const std::string& name, const VmdKey& key, const Quat& turn) {
        append_padded(out_, name, kBoneNameBytes);
        append_word(out_, static_cast<std::uint32_t>(key.frame));
        out_.append(12, '\0');  // no movement away from rest
        for (const double part : {-turn.x, -turn.y, turn.z, turn.w}) append_float(out_, part);
        out_ += key.is_change ? late_ : linear_;
    }

    const PosedHair& hair_;
    const std::vector<VmdKey> keys_;
    const std::string linear_, late_;
    std::string out_;
};

}  // namespace

std::vector<VmdKey> vmd_keys(const Schedule& schedule, int repeat) {
    std::vector<VmdKey> keys;
    for (int cycle = 0; cycle < repeat; ++cycle) {
        for (int n = 0; n < schedule.pictures; ++n) {
            const auto picture = static_cast<std::size_t>(n);
            const int start = cycle * schedule.frames + schedule.starts[picture];
            keys.push_back({start, n, start > 0});
            if (schedule.holds[picture] > 1) keys.push_back({start + schedule.holds[picture] - 1, n, false});
        }
    }
    keys.push_back({repeat * schedule.frames, 0, true});
    return keys;
}

Result<std::string> vmd(const PosedHair& hair, int repeat) { return VmdWriter(hair, repeat).write(); }

}  // namespace tuftwave::server::poses
