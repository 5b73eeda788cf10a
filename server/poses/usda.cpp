#include "poses/usda.hpp"

#include <array>
#include <charconv>
#include <string_view>

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

/// A joint at rest.
struct Joint {
    std::string_view path;
    Quat global, local;
    Vec3 origin, translation;  ///< in the model, and from its parent
};

/// Lists something of every joint, right where it will stay: a path names all joints above, so that those of long
/// chains are most of the file. @param append  adds one item to a text
template <class Append>
void append_joints(std::string& text, const PosedHair& hair, const BoneNames& names, const Append& append) {
    const char* comma = "[";
    for (std::size_t c = 0; c < hair.chains.size(); ++c) {
        const Chain& chain = hair.chains[c];
        Quat global;
        Vec3 origin;
        std::string path;
        for (std::size_t i = 0; i + 1 < chain.nodes.size(); ++i) {
            path.append(i == 0 ? "" : "/").append(names[c][i]);
            const Quat rotation = normalized(chain.rest_rotations[i]);
            // What the chain hangs on is no joint, so that its rotation belongs to the first one.
            const Quat local = i == 0 ? normalized(chain.parent_rotation) * rotation : rotation;
            const Vec3 translation = rotated(inverse(global), chain.nodes[i] - origin);
            global = global * local;
            origin = chain.nodes[i];
            append(text += comma, Joint{path, global, local, origin, translation});
            comma = ", ";
        }
    }
    text += ']';
}

/// The rotations of all joints in a picture.
void append_picture(std::string& text, const PosedHair& hair, std::size_t picture) {
    const char* comma = "[";
    for (std::size_t c = 0; c < hair.chains.size(); ++c) {
        const std::size_t nodes = hair.chains[c].nodes.size();
        const Quat parent = normalized(hair.chains[c].parent_rotation);
        for (std::size_t i = 0; i + 1 < nodes; ++i) {
            const Quat& own = hair.motion.chains[c].rotations[picture * nodes + i];
            const Quat q = i == 0 ? normalized(parent * own) : own;
            append_list(text += comma, {q.w, q.x, q.y, q.z});
            comma = ", ";
        }
    }
    text += ']';
}

/// "1.999" for the last sample before frame 2: a thousandth of a frame is well told apart and never seen.
std::string just_before(int frame) { return std::to_string(frame - 1) + ".999"; }

void append_samples(std::string& text, const PosedHair& hair) {
    const Schedule& schedule = hair.motion.schedule;
    text += "{\n";
    const auto begin = [&](const std::string& time) { text.append("                ").append(time).append(": "); };
    const auto add_again = [&](const std::string& time, std::size_t first, std::size_t bytes) {
        begin(time);
        text.append(text, first, bytes).append(",\n");
    };
    std::size_t first_list = 0, first_bytes = 0;
    for (std::size_t n = 0; n < static_cast<std::size_t>(schedule.pictures); ++n) {
        begin(std::to_string(schedule.starts[n]));
        const std::size_t list = text.size();
        append_picture(text, hair, n);
        const std::size_t bytes = text.size() - list;
        text += ",\n";
        add_again(just_before(schedule.starts[n] + schedule.holds[n]), list, bytes);
        if (n == 0) first_list = list, first_bytes = bytes;
    }
    add_again(std::to_string(schedule.frames), first_list, first_bytes);
    text += "            }";
}

/// No file is longer. Room that is never written costs nothing, growing would cost a copy of it all.
std::size_t most_bytes(const PosedHair& hair, const BoneNames& names) {
    constexpr std::size_t kNumber = 28, kRest = (2 * 16 + 3 + 1) * kNumber, kRotation = 4 * kNumber;
    const std::size_t keys = 2 * static_cast<std::size_t>(hair.motion.schedule.pictures) + 1;
    std::size_t most = 4096 + keys * 64;
    for (const std::vector<std::string>& chain : names) {
        std::size_t path = 0;
        for (const std::string& name : chain) {
            path += name.size() + 1;
            most += 2 * (path + 4) + kRest + keys * kRotation;
        }
    }
    return most;
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
    std::string text;
    text.reserve(most_bytes(hair, names));
    text += layer_head(hair.motion.schedule);
    text += "def SkelRoot \"hair\" (\n    prepend apiSchemas = [\"SkelBindingAPI\"]\n)\n{\n";
    text += "    def Skeleton \"skeleton\" (\n        prepend apiSchemas = [\"SkelBindingAPI\"]\n    )\n    {\n";
    text += "        uniform matrix4d[] bindTransforms = ";
    append_joints(text, hair, names,
                  [](std::string& to, const Joint& joint) { append_matrix(to, joint.global, joint.origin); });
    text += "\n        uniform token[] joints = ";
    const std::size_t paths = text.size();
    append_joints(text, hair, names,
                  [](std::string& to, const Joint& joint) { to.append("\"").append(joint.path).append("\""); });
    const std::size_t path_bytes = text.size() - paths;
    text += "\n        uniform matrix4d[] restTransforms = ";
    append_joints(text, hair, names,
                  [](std::string& to, const Joint& joint) { append_matrix(to, joint.local, joint.translation); });
    text +=
        "\n        rel skel:animationSource = </hair/skeleton/wave>\n\n        def SkelAnimation \"wave\"\n        {\n";
    text += "            uniform token[] joints = ";
    text.append(text, paths, path_bytes).append("\n            quatf[] rotations.timeSamples = ");
    append_samples(text, hair);
    text += "\n            half3[] scales = ";
    append_joints(text, hair, names, [](std::string& to, const Joint&) { to += "(1, 1, 1)"; });
    text += "\n            float3[] translations = ";
    append_joints(text, hair, names, [](std::string& to, const Joint& joint) {
        append_list(to, {joint.translation.x, joint.translation.y, joint.translation.z});
    });
    text += "\n        }\n    }\n}\n";
    return text;
}

}  // namespace tuftwave::server::poses
