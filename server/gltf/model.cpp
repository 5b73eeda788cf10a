#include "gltf/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace tuftwave::server::gltf {
namespace {

using Model = Document::Model;

constexpr double kSame = 1e-12;

// Words are chosen by branches, not by value, so that each is copied as a text of known length.

void write_shape(Document::Shape shape, JsonText& to) {
    switch (shape) {
        case Document::Shape::kScalar:
            to.raw("\"SCALAR\"");
            return;
        case Document::Shape::kVec2:
            to.raw("\"VEC2\"");
            return;
        case Document::Shape::kVec3:
            to.raw("\"VEC3\"");
            return;
        case Document::Shape::kVec4:
            to.raw("\"VEC4\"");
            return;
        case Document::Shape::kMat4:
            to.raw("\"MAT4\"");
            return;
    }
}

void write_path(Document::Path path, JsonText& to) {
    if (path == Document::Path::kRotation) {
        to.raw("\"rotation\"");
    } else {
        to.raw("\"scale\"");
    }
}

void write_interpolation(Document::Interpolation interpolation, JsonText& to) {
    if (interpolation == Document::Interpolation::kStep) {
        to.raw("\"STEP\"");
    } else {
        to.raw("\"LINEAR\"");
    }
}

template <class Numbers>
void write_numbers(JsonText& to, const Numbers& numbers) {
    to.open('[');
    for (const auto number : numbers) to.next().number(number);
    to.close(']');
}

/// A member that is a list of objects; none at all where the list is empty. @param write  what is between their braces
template <class Items, class Write>
void write_list(JsonText& to, std::string_view key, const Items& items, const Write& write) {
    if (items.empty()) return;
    to.key(key).open('[');
    for (const auto& item : items) {
        to.next().open('{');
        write(item);
        to.close('}');
    }
    to.close(']');
}

void write_accessors(const Model& model, JsonText& to) {
    std::vector<const Model::Bounded*> bounds(model.accessors.size(), nullptr);
    for (const Model::Bounded& bounded : model.bounds) bounds[static_cast<std::size_t>(bounded.accessor)] = &bounded;
    std::size_t at = 0;
    write_list(to, "accessors", model.accessors, [&](const Document::Accessor& accessor) {
        const Model::Bounded* const bounded = bounds[at++];
        to.raw(R"("bufferView":)").number(accessor.view);
        if (accessor.offset != 0) to.raw(R"(,"byteOffset":)").number(accessor.offset);
        to.raw(R"(,"componentType":)").number(static_cast<int>(accessor.component));
        to.raw(R"(,"count":)").number(accessor.count);
        if (bounded != nullptr) {
            const std::size_t width = width_of(accessor.shape);
            write_numbers(to.raw(R"(,"max":)"), std::span(bounded->box.most).first(width));
            write_numbers(to.raw(R"(,"min":)"), std::span(bounded->box.least).first(width));
        }
        if (accessor.is_normalized) to.raw(R"(,"normalized":true)");
        write_shape(accessor.shape, to.raw(R"(,"type":)"));
    });
}

void write_animations(const Model& model, JsonText& to) {
    write_list(to, "animations", model.animations, [&](const Model::Animation& animation) {
        int sampler = 0;
        write_list(to, "channels", animation.channels, [&](const Document::Channel& channel) {
            to.raw(R"("sampler":)").number(sampler++).raw(R"(,"target":{"node":)").number(channel.node);
            write_path(channel.path, to.raw(R"(,"path":)"));
            to.raw("}");
        });
        if (!animation.extras.empty()) to.key("extras").raw(animation.extras);
        to.key("name").text(animation.name);
        write_list(to, "samplers", animation.channels, [&](const Document::Channel& channel) {
            to.raw(R"("input":)").number(animation.times).raw(R"(,"interpolation":)");
            write_interpolation(animation.interpolation, to);
            to.raw(R"(,"output":)").number(channel.values);
        });
    });
}

void write_packed(const Model::Packed& packed, JsonText& to) {
    to.raw(R"(,"extensions":)").open('{').key("EXT_meshopt_compression").open('{');
    to.key("buffer").number(0).key("byteLength").number(packed.bytes).key("byteOffset").number(packed.offset);
    to.key("byteStride").number(packed.stride).key("count").number(packed.count).key("mode");
    to.raw(packed.mode == Model::Packed::Mode::kTriangles ? "\"TRIANGLES\"" : "\"ATTRIBUTES\"").close('}').close('}');
}

void write_views(const Model& model, JsonText& to) {
    write_list(to, "bufferViews", model.views, [&](const Model::View& view) {
        to.raw(R"("buffer":)").raw(view.packed ? "1" : "0").raw(R"(,"byteLength":)").number(view.bytes);
        if (view.offset > 0) to.raw(R"(,"byteOffset":)").number(view.offset);
        if (view.stride > 0) to.raw(R"(,"byteStride":)").number(view.stride);
        if (view.packed) write_packed(*view.packed, to);
        if (view.purpose == Document::Purpose::kData) return;
        if (view.purpose == Document::Purpose::kAttribute) {
            to.raw(R"(,"target":34962)");
        } else {
            to.raw(R"(,"target":34963)");
        }
    });
}

/// A buffer that is only there for views to be views of: whoever unpacks them makes it.
void write_fallback(std::size_t bytes, JsonText& to) {
    to.next().open('{').key("byteLength").number(bytes).key("extensions").open('{');
    to.key("EXT_meshopt_compression").open('{').key("fallback").raw("true").close('}').close('}').close('}');
}

void write_extensions(const Model& model, JsonText& to) {
    if (model.extensions.empty()) return;
    for (const std::string_view key : {"extensionsRequired", "extensionsUsed"}) {
        to.key(key).open('[');
        for (const std::string_view name : model.extensions) to.next().raw("\"").raw(name).raw("\"");
        to.close(']');
    }
}

void write_materials(const Model& model, JsonText& to) {
    const auto is_one = [](double channel) { return std::abs(channel - 1) < kSame; };
    write_list(to, "materials", model.materials, [&](const Model::Material& material) {
        to.key("name").text(material.name).key("pbrMetallicRoughness").open('{');
        const auto& color = material.color;
        if (!std::all_of(color.begin(), color.end(), is_one))  // white need not be said
            write_numbers(to.key("baseColorFactor"), std::array<double, 4>{color[0], color[1], color[2], 1.0});
        to.key("metallicFactor").number(0.0).key("roughnessFactor").number(0.9).close('}');
    });
}

void write_meshes(const Model& model, JsonText& to) {
    constexpr int kTriangles = 4;
    write_list(to, "meshes", model.meshes, [&](const Model::Mesh& mesh) {
        const Document::Primitive& primitive = mesh.primitive;
        if (!mesh.name.empty()) to.key("name").text(mesh.name);
        to.key("primitives").open('[').next().open('{').key("attributes").open('{');
        if (primitive.joints) to.key("JOINTS_0").number(*primitive.joints);
        to.key("NORMAL").number(primitive.normals).key("POSITION").number(primitive.positions);
        to.key("TEXCOORD_0").number(primitive.uvs);
        if (primitive.weights) to.key("WEIGHTS_0").number(*primitive.weights);
        to.close('}').key("indices").number(primitive.indices).key("material").number(primitive.material);
        to.key("mode").number(kTriangles).close('}').close(']');
    });
}

/// The children of each of a model's nodes, in order.
class Children {
  public:
    explicit Children(const std::vector<Model::Placed>& nodes) : families_(nodes.size()) {
        for (std::size_t i = nodes.size(); i-- > 0;) {
            if (!nodes[i].parent) continue;
            int& first = families_[static_cast<std::size_t>(*nodes[i].parent)].first_child;
            families_[i].next_sibling = first;
            first = static_cast<int>(i);
        }
    }

    void write(std::size_t node, JsonText& to) const {
        if (families_[node].first_child == kNone) return;
        to.key("children").open('[');
        for (int child = families_[node].first_child; child != kNone;) {
            to.next().number(child);
            child = families_[static_cast<std::size_t>(child)].next_sibling;
        }
        to.close(']');
    }

  private:
    static constexpr int kNone = -1;
    struct Family {
        int first_child = kNone, next_sibling = kNone;
    };

    std::vector<Family> families_;
};

void write_nodes(const Model& model, JsonText& to) {
    const Children children(model.nodes);
    std::size_t at = 0;
    write_list(to, "nodes", model.nodes, [&](const Model::Placed& placed) {
        children.write(at++, to);
        if (placed.extras.bytes > 0) to.key("extras").raw(model.text(placed.extras));
        if (placed.members.bytes > 0) to.next().raw(model.text(placed.members));
    });
}

void write_skins(const Model& model, JsonText& to) {
    write_list(to, "skins", model.skins, [&](const Model::Skin& skin) {
        to.key("inverseBindMatrices").number(skin.matrices);
        write_numbers(to.key("joints"), skin.joints);
        to.key("skeleton").number(skin.root);
    });
}

}  // namespace

Model::Text Document::Model::add_text(std::string_view text) {
    texts += text;
    return {texts.size() - text.size(), text.size()};
}

Model::Text Document::Model::add_members(const Node& node) {
    constexpr std::size_t kMostNumbers = 512, kMostEscaped = 6;  // bytes of all numbers and keys, of a letter
    std::array<char, 2 * kMostNumbers> usual;                    // a name has 15 bytes in our own files
    std::string large;
    const std::size_t most = kMostNumbers + kMostEscaped * node.name.size();
    if (most > usual.size()) large.resize(most);
    char* const room = large.empty() ? usual.data() : large.data();
    JsonText to(room);
    if (node.mesh) to.key("mesh").number(*node.mesh);
    if (!node.name.empty()) to.key("name").text(node.name);
    if (node.rotation) write_numbers(to.key("rotation"), *node.rotation);
    if (node.scale) write_numbers(to.key("scale"), std::array<double, 3>{*node.scale, *node.scale, *node.scale});
    if (node.skin) to.key("skin").number(*node.skin);
    if (node.translation) write_numbers(to.key("translation"), *node.translation);
    return add_text({room, to.bytes()});
}

std::size_t size_of(Document::Component component) {
    switch (component) {
        case Document::Component::kI8:
        case Document::Component::kU8:
            return 1;
        case Document::Component::kU16:
            return 2;
        case Document::Component::kU32:
        case Document::Component::kF32:
            return 4;
    }
    return 0;
}

std::size_t width_of(Document::Shape shape) {
    switch (shape) {
        case Document::Shape::kScalar:
            return 1;
        case Document::Shape::kVec2:
            return 2;
        case Document::Shape::kVec3:
            return 3;
        case Document::Shape::kVec4:
            return 4;
        case Document::Shape::kMat4:
            return 16;
    }
    return 0;
}

std::size_t most_json_bytes(const Model& model) {
    // Of one item at most, with its keys, its numbers and its comma; of a number in a list; of a character in a text.
    constexpr std::size_t kFrame = 512, kView = 384, kAccessor = 192, kBounds = 224, kNode = 64, kMaterial = 256;
    constexpr std::size_t kMesh = 320, kSkin = 128, kAnimation = 128, kChannelAndSampler = 192;
    constexpr std::size_t kIndex = 12, kCharacter = 6;
    std::size_t bytes = kFrame + model.generator.size() * kCharacter + model.extras.size();
    for (const auto& extension : model.extensions) bytes += 2 * (extension.size() * kCharacter + 3);
    bytes += model.views.size() * kView + model.accessors.size() * kAccessor + model.roots.size() * kIndex;
    for (const Document::Accessor& accessor : model.accessors) bytes += accessor.is_bounded ? kBounds : 0;
    bytes += model.nodes.size() * (kNode + kIndex) + model.texts.size();
    for (const Model::Material& material : model.materials) bytes += kMaterial + material.name.size() * kCharacter;
    for (const Model::Mesh& mesh : model.meshes) bytes += kMesh + mesh.name.size() * kCharacter;
    for (const Model::Skin& skin : model.skins) bytes += kSkin + skin.joints.size() * kIndex;
    for (const Model::Animation& animation : model.animations) {
        bytes += kAnimation + animation.name.size() * kCharacter + animation.extras.size();
        bytes += animation.channels.size() * kChannelAndSampler;
    }
    return bytes;
}

char* write_glb_heads(char* file, std::size_t text, std::size_t data) {
    const auto number = [&](std::size_t value) {
        for (int i = 0; i < 4; ++i) *file++ = static_cast<char>(value >> (8 * i) & 0xFF);
    };
    number(0x46546C67);
    number(2);
    number((data > 0 ? kGlbHeads : kGlbTextAt) + text + data);
    number(text);
    number(0x4E4F534A);
    file += text;
    if (data == 0) return file;
    number(data);
    number(0x004E4942);
    return file;
}

void write_json(const Model& model, JsonText& to, const std::function<void(JsonText&)>& uri) {
    to.open('{');
    write_accessors(model, to);
    write_animations(model, to);
    to.key("asset").open('{');
    if (!model.extras.empty()) to.key("extras").raw(model.extras);
    to.key("generator").text(model.generator).key("version").text("2.0").close('}');
    write_views(model, to);
    to.key("buffers").open('[').next().open('{').key("byteLength").number(model.bytes);
    if (uri) {
        to.key("uri").raw("\"data:application/octet-stream;base64,");
        uri(to);
        to.raw("\"");
    }
    to.close('}');
    if (model.fallback > 0) write_fallback(model.fallback, to);
    to.close(']');
    write_extensions(model, to);
    write_materials(model, to);
    write_meshes(model, to);
    write_nodes(model, to);
    to.key("scene").number(0).key("scenes").open('[').next().open('{');
    if (!model.roots.empty()) write_numbers(to.key("nodes"), model.roots);
    to.close('}').close(']');
    write_skins(model, to);
    to.close('}');
}

}  // namespace tuftwave::server::gltf
