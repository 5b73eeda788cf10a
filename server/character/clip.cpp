#include "character/clip.hpp"

#include <cstring>
#include <utility>

namespace tuftwave::server::character {
namespace {

constexpr int kFloat = 5126;

void append(std::string& bytes, float number) {
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    bytes.append(raw, sizeof number);
}

/// Appends to one of the file's lists, which is made where it is missing. @return  the new item's index
std::size_t add_to(FileJson& file, const char* list, FileJson item) {
    FileJson& items = file[list];
    items.push_back(std::move(item));
    return items.size() - 1;
}

class Adder {
  public:
    Adder(FileJson& file, std::size_t binary_bytes) : file_(file), start_(binary_bytes) {}

    std::size_t add_view(std::size_t first_byte) {
        return add_to(file_, "bufferViews",
                      {{"buffer", 0}, {"byteOffset", start_ + first_byte}, {"byteLength", bytes_.size() - first_byte}});
    }

    std::size_t add_times(const std::vector<float>& times) {
        for (const float time : times) append(bytes_, time);
        return add_to(file_, "accessors",
                      {{"bufferView", add_view(0)},
                       {"componentType", kFloat},
                       {"count", times.size()},
                       {"type", "SCALAR"},
                       {"min", {times.front()}},
                       {"max", {times.back()}}});
    }

    void write_rotations(const std::vector<Quat>& rotations, const std::vector<std::size_t>& pictures) {
        for (const std::size_t picture : pictures) {
            const Quat& q = rotations[picture];
            for (const double part : {q.x, q.y, q.z, q.w}) append(bytes_, static_cast<float>(part));
        }
    }

    std::string finish() {
        FileJson& buffers = file_["buffers"];
        if (buffers.empty()) buffers.push_back(FileJson::object());
        buffers[0]["byteLength"] = start_ + bytes_.size();
        return std::move(bytes_);
    }

    std::size_t written() const { return bytes_.size(); }

  private:
    FileJson& file_;
    const std::size_t start_;
    std::string bytes_;
};

/// A node that is animated must not state a matrix.
void replace_matrix(FileJson& node, const Placement& local) {
    const auto& [t, r, s] = local;
    node.erase("matrix");
    node["translation"] = {t.x, t.y, t.z};
    node["rotation"] = {r.x, r.y, r.z, r.w};
    node["scale"] = {s.x, s.y, s.z};
}

}  // namespace

std::optional<Fault> check_clip_fits(const FileJson& json, const std::string& name, std::size_t binary_bytes) {
    std::optional<Fault> fault;
    const FileValue file(&json, "", fault);
    for (const char* list : {"accessors", "bufferViews"}) file[list].size();
    const FileValue animations = file["animations"], buffers = file["buffers"];
    for (std::size_t i = 0, count = animations.size(); i < count; ++i) {
        if (animations.at(i)["name"].text() == name)
            animations.at(i)["name"].refuse(Fault::Kind::kConflict, "another name than the new clip's, see ?clip_name");
    }
    if (buffers.size() > 0) {
        const FileValue own = buffers.at(0);
        if (own["uri"].exists())
            own["uri"].refuse(Fault::Kind::kUnsupported, "a buffer in the file itself, without uri");
        own["byteLength"].whole(binary_bytes);
    }
    return fault;
}

std::string add_held_clip(FileJson& file, const Character& character, const std::vector<NodeKeys>& nodes,
                          const gltf::ClipKeys& keys, const std::string& name, const FileJson& extras,
                          std::size_t binary_bytes) {
    Adder adder(file, binary_bytes);
    const std::size_t times = adder.add_times(keys.times), first_byte = adder.written();
    const std::size_t key_bytes = keys.times.size() * 4 * sizeof(float);
    for (const NodeKeys& node : nodes) adder.write_rotations(node.rotations, keys.pictures);
    const std::size_t view = adder.add_view(first_byte);

    FileJson samplers = FileJson::array(), channels = FileJson::array();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::size_t accessor = add_to(file, "accessors",
                                            {{"bufferView", view},
                                             {"byteOffset", i * key_bytes},
                                             {"componentType", kFloat},
                                             {"count", keys.times.size()},
                                             {"type", "VEC4"}});
        samplers.push_back(
            {{"input", times}, {"interpolation", keys.is_stepped ? "STEP" : "LINEAR"}, {"output", accessor}});
        channels.push_back({{"sampler", i}, {"target", {{"node", nodes[i].node}, {"path", "rotation"}}}});
        const Node& node = character.nodes[static_cast<std::size_t>(nodes[i].node)];
        if (node.has_matrix) replace_matrix(file["nodes"][static_cast<std::size_t>(nodes[i].node)], node.local);
    }
    add_to(file, "animations",
           {{"name", name}, {"channels", std::move(channels)}, {"samplers", std::move(samplers)}, {"extras", extras}});
    return adder.finish();
}

}  // namespace tuftwave::server::character
