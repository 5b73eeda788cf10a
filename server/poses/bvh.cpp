#include "poses/bvh.hpp"

#include <charconv>

#include "poses/euler.hpp"

namespace tuftwave::server::poses {
namespace {

const std::string kRoot = "hair_root";

bool is_allowed(char c) { return static_cast<unsigned char>(c) > ' ' && c != '\x7f' && c != '{' && c != '}'; }

class BvhWriter {
  public:
    explicit BvhWriter(const PosedHair& hair) : hair_(hair), names_(legal_names(hair.names, is_allowed, kRoot)) {}

    std::string write() {
        text_ = "HIERARCHY\n";
        open("ROOT " + kRoot, {});
        line("CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation");
        for (std::size_t c = 0; c < hair_.chains.size(); ++c) write_chain(hair_.chains[c], names_[c]);
        close();
        write_motion();
        return std::move(text_);
    }

  private:
    void line(const std::string& words) { text_.append(2 * depth_, ' ').append(words).push_back('\n'); }

    void open(const std::string& words, const Vec3& offset) {
        line(words);
        line("{");
        ++depth_;
        std::string numbers = "OFFSET";
        for (const double part : {offset.x, offset.y, offset.z}) append_number(numbers += ' ', part);
        line(numbers);
    }

    void close() {
        --depth_;
        line("}");
    }

    void write_chain(const Chain& chain, const std::vector<std::string>& names) {
        const std::size_t bones = chain.nodes.size() - 1;
        for (std::size_t i = 0; i < bones; ++i) {
            open("JOINT " + names[i], i == 0 ? chain.nodes[0] : chain.nodes[i] - chain.nodes[i - 1]);
            line("CHANNELS 3 Zrotation Xrotation Yrotation");
        }
        open("End Site", chain.nodes[bones] - chain.nodes[bones - 1]);
        for (std::size_t i = 0; i <= bones; ++i) close();
    }

    void write_motion() {
        const Schedule& schedule = hair_.motion.schedule;
        char seconds[32];
        const double frame =
            static_cast<double>(schedule.fps.denominator) / static_cast<double>(schedule.fps.numerator);
        const auto end = std::to_chars(seconds, seconds + sizeof seconds, frame, std::chars_format::fixed, 12).ptr;
        text_ +=
            "MOTION\nFrames: " + std::to_string(schedule.frames) + "\nFrame Time: " + std::string(seconds, end) + "\n";

        std::vector<std::string> pictures(static_cast<std::size_t>(schedule.pictures), "0 0 0 0 0 0");
        for (std::size_t c = 0; c < hair_.chains.size(); ++c) append_angles(c, pictures);
        for (std::size_t n = 0; n < pictures.size(); ++n) {
            for (int held = 0; held < schedule.holds[n]; ++held) text_ += pictures[n] + "\n";
        }
    }

    /// Adds the angles of a chain's bones to the line of each picture.
    void append_angles(std::size_t chain, std::vector<std::string>& pictures) const {
        const std::vector<Quat> turns = bone_turns(hair_.chains[chain], hair_.motion.chains[chain].rotations);
        const std::size_t nodes = hair_.chains[chain].nodes.size();
        for (std::size_t n = 0; n < pictures.size(); ++n) {
            for (std::size_t i = 0; i + 1 < nodes; ++i) {
                const auto [z, x, y] = zxy_angles(turns[n * nodes + i]);
                for (const double angle : {z, x, y}) append_number(pictures[n] += ' ', angle / kRadiansPerDegree);
            }
        }
    }

    const PosedHair& hair_;
    const BoneNames names_;
    std::string text_;
    std::size_t depth_ = 0;
};

}  // namespace

std::string bvh(const PosedHair& hair) { return BvhWriter(hair).write(); }

}  // namespace tuftwave::server::poses
