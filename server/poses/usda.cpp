#include "poses/usda.hpp"

#include <array>
#include <charconv>

namespace tuftwave::server::poses {
namespace {

bool is_allowed(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

void append_list(std::string& text, std::initializer_list<double> numbers) {
    text += '(';
    const char* comma = "";
    for (const double number : numbers) {
        append_number(text += comma, number);
        comma = ", ";
    }
    text += ')';
}

/// A rigid motion as USD writes matrices, which act on row vectors: the images of the axes, then the origin's.
void append_matrix(std::string& text, const Quat& rotation, const Vec3& origin) {
    text += "( ";
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        const Vec3 image = rotated(rotation, axis);
        append_list(text, {image.x, image.y, image.z, 0});
        text += ", ";
    }
    append_list(text, {origin.x, origin.y, origin.z, 1});
    text += " )";
}

/// The values of all bones, written down one after the other.
class Values {
  public:
    std::string& next() { return text_ += text_.empty() ? "" : ", "; }
    std::string list() const { return "[" + text_ + "]"; }

  private:
    std::string text_;
};

struct RestPose {
    Values joints, bind, rest, translations, scales;
};

void add_chain(RestPose& pose, const Chain& chain, const std::vector<std::string>& names) {
    Quat global;
    Vec3 origin;
    std::string path;
    for (std::size_t i = 0; i + 1 < chain.nodes.size(); ++i) {
        path += (i == 0 ? "" : "/") + names[i];
        pose.joints.next() += "\"" + path + "\"";
        const Quat rotation = normalized(chain.rest_rotations[i]);
        // What the chain hangs on is no joint, so that its rotation belongs to the first one.
        const Quat local = i == 0 ? normalized(chain.parent_rotation) * rotation : rotation;
        const Vec3 translation = rotated(inverse(global), chain.nodes[i] - origin);
        global = global * local;
        origin = chain.nodes[i];
        append_matrix(pose.bind.next(), global, origin);
        append_matrix(pose.rest.next(), local, translation);
        append_list(pose.translations.next(), {translation.x, translation.y, translation.z});
        pose.scales.next() += "(1, 1, 1)";
    }
}

std::vector<Values> rotations_of_pictures(const PosedHair& hair) {
    std::vector<Values> pictures(static_cast<std::size_t>(hair.motion.schedule.pictures));
    for (std::size_t c = 0; c < hair.chains.size(); ++c) {
        const std::vector<Quat>& rotations = hair.motion.chains[c].rotations;
        const std::size_t nodes = hair.chains[c].nodes.size();
        for (std::size_t n = 0; n < pictures.size(); ++n) {
            for (std::size_t i = 0; i + 1 < nodes; ++i) {
                const Quat& own = rotations[n * nodes + i];
                const Quat q = i == 0 ? normalized(normalized(hair.chains[c].parent_rotation) * own) : own;
                append_list(pictures[n].next(), {q.w, q.x, q.y, q.z});
            }
        }
    }
    return pictures;
}

/// "1.999" for the last sample before frame 2: a thousandth of a frame is well told apart and never seen.
std::string just_before(int frame) { return std::to_string(frame - 1) + ".999"; }

std::string samples(const PosedHair& hair) {
    const Schedule& schedule = hair.motion.schedule;
    const std::vector<Values> pictures = rotations_of_pictures(hair);
    std::string text = "{\n";
    const auto add = [&](const std::string& time, const std::string& list) {
        text += "                " + time + ": " + list + ",\n";
    };
    for (std::size_t n = 0; n < pictures.size(); ++n) {
        const std::string list = pictures[n].list();
        add(std::to_string(schedule.starts[n]), list);
        add(just_before(schedule.starts[n] + schedule.holds[n]), list);
    }
    add(std::to_string(schedule.frames), pictures.front().list());
    return text + "            }";
}

std::string layer_head(const Schedule& schedule) {
    char digits[32];
    const std::string fps(digits, std::to_chars(digits, digits + sizeof digits, schedule.fps.value()).ptr);
    return "#usda 1.0\n(\n    defaultPrim = \"hair\"\n    endTimeCode = " + std::to_string(schedule.frames - 1) +
           "\n    framesPerSecond = " + fps +
           "\n    metersPerUnit = 1\n    startTimeCode = 0\n    timeCodesPerSecond = " + fps +
           "\n    upAxis = \"Y\"\n)\n\n";
}

}  // namespace

std::string usda(const PosedHair& hair) {
    const BoneNames names = legal_names(hair.names, is_allowed, "hair_root");
    RestPose pose;
    for (std::size_t c = 0; c < hair.chains.size(); ++c) add_chain(pose, hair.chains[c], names[c]);
    std::string text = layer_head(hair.motion.schedule);
    text += "def SkelRoot \"hair\" (\n    prepend apiSchemas = [\"SkelBindingAPI\"]\n)\n{\n";
    text += "    def Skeleton \"skeleton\" (\n        prepend apiSchemas = [\"SkelBindingAPI\"]\n    )\n    {\n";
    text += "        uniform matrix4d[] bindTransforms = " + pose.bind.list() + "\n";
    text += "        uniform token[] joints = " + pose.joints.list() + "\n";
    text += "        uniform matrix4d[] restTransforms = " + pose.rest.list() + "\n";
    text +=
        "        rel skel:animationSource = </hair/skeleton/wave>\n\n        def SkelAnimation \"wave\"\n        {\n";
    text += "            uniform token[] joints = " + pose.joints.list() + "\n";
    text += "            quatf[] rotations.timeSamples = " + samples(hair) + "\n";
    text += "            half3[] scales = " + pose.scales.list() + "\n";
    text += "            float3[] translations = " + pose.translations.list() + "\n";
    return text + "        }\n    }\n}\n";
}

}  // namespace tuftwave::server::poses
