#include "gltf/document.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>
#include <streambuf>
#include <utility>

namespace tuftwave::server::gltf {
namespace {

constexpr std::size_t kAlignment = 4;

std::size_t aligned(std::size_t bytes) { return (bytes + kAlignment - 1) / kAlignment * kAlignment; }

/// Deep at most as our own answers are, never as a client's JSON.
tinygltf::Value to_value(const nlohmann::json& json) {
    if (json.is_object()) {
        tinygltf::Value::Object object;
        for (const auto& [key, value] : json.items()) object.emplace(key, to_value(value));
        return tinygltf::Value(std::move(object));
    }
    if (json.is_array()) {
        tinygltf::Value::Array array;
        for (const auto& value : json) array.push_back(to_value(value));
        return tinygltf::Value(std::move(array));
    }
    if (json.is_boolean()) return tinygltf::Value(json.get<bool>());
    if (json.is_number_integer() && std::in_range<int>(json.get<std::int64_t>()))
        return tinygltf::Value(json.get<int>());
    if (json.is_number()) return tinygltf::Value(json.get<double>());
    if (json.is_string()) return tinygltf::Value(json.get<std::string>());
    return {};
}

int type_of(Document::Shape shape) {
    switch (shape) {
        case Document::Shape::kScalar:
            return TINYGLTF_TYPE_SCALAR;
        case Document::Shape::kVec2:
            return TINYGLTF_TYPE_VEC2;
        case Document::Shape::kVec3:
            return TINYGLTF_TYPE_VEC3;
        case Document::Shape::kVec4:
            return TINYGLTF_TYPE_VEC4;
        case Document::Shape::kMat4:
            return TINYGLTF_TYPE_MAT4;
    }
    return 0;
}

/// Lets tinygltf write into a string: an ostringstream is ten times slower and holds everything twice.
class StringBuffer final : public std::streambuf {
  public:
    explicit StringBuffer(std::string& out) : out_(out) {}

  protected:
    std::streamsize xsputn(const char* text, std::streamsize count) override {
        out_.append(text, static_cast<std::size_t>(count));
        return count;
    }
    int_type overflow(int_type character) override {
        if (character != traits_type::eof()) out_.push_back(static_cast<char>(character));
        return character;
    }

  private:
    std::string& out_;
};

template <class Items, class Item>
int appended(Items& items, Item&& item) {
    items.push_back(std::forward<Item>(item));
    return static_cast<int>(items.size()) - 1;
}

}  // namespace

struct Document::Model : tinygltf::Model {
    tinygltf::Accessor& accessor(int index) { return accessors[static_cast<std::size_t>(index)]; }
    tinygltf::BufferView& view(int index) { return bufferViews[static_cast<std::size_t>(index)]; }
    tinygltf::Node& node(int index) { return nodes[static_cast<std::size_t>(index)]; }
    std::size_t reserved_bytes = 0;
};

Document::Document(const std::string& generator) : model_(std::make_unique<Model>()) {
    model_->asset.version = "2.0";
    model_->asset.generator = generator;
    model_->scenes.emplace_back();
    model_->defaultScene = 0;
    model_->buffers.emplace_back();
}

Document::~Document() = default;

int Document::add_view(Purpose purpose, std::size_t bytes, std::size_t stride) {
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = model_->reserved_bytes;
    view.byteLength = bytes;
    if (purpose == Purpose::kAttribute) {
        view.byteStride = stride;
        view.target = TINYGLTF_TARGET_ARRAY_BUFFER;
    } else if (purpose == Purpose::kIndex) {
        view.target = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
    }
    model_->reserved_bytes += aligned(bytes);
    return appended(model_->bufferViews, std::move(view));
}

int Document::add_accessor(const Accessor& accessor) {
    tinygltf::Accessor made;
    made.bufferView = accessor.view;
    made.byteOffset = accessor.offset;
    made.count = accessor.count;
    made.componentType = static_cast<int>(accessor.component);
    made.type = type_of(accessor.shape);
    return appended(model_->accessors, std::move(made));
}

int Document::add_node(const Node& node) {
    tinygltf::Node made;
    made.name = node.name;
    if (node.translation) made.translation.assign(node.translation->begin(), node.translation->end());
    if (node.rotation) made.rotation.assign(node.rotation->begin(), node.rotation->end());
    if (node.scale) made.scale.assign(3, *node.scale);
    if (node.mesh) made.mesh = *node.mesh;
    if (node.skin) made.skin = *node.skin;
    return appended(model_->nodes, std::move(made));
}

void Document::add_child(int parent, int child) { model_->node(parent).children.push_back(child); }

void Document::add_to_scene(int node) { model_->scenes.front().nodes.push_back(node); }

int Document::add_material(const std::string& name, std::array<double, 3> linear_color) {
    tinygltf::Material material;
    material.name = name;
    material.pbrMetallicRoughness.baseColorFactor = {linear_color[0], linear_color[1], linear_color[2], 1.0};
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 0.9;
    return appended(model_->materials, std::move(material));
}

int Document::add_mesh(const std::string& name, const Primitive& primitive) {
    tinygltf::Primitive made;
    made.attributes = {{"POSITION", primitive.positions}, {"NORMAL", primitive.normals}, {"TEXCOORD_0", primitive.uvs}};
    if (primitive.joints) made.attributes["JOINTS_0"] = *primitive.joints;
    if (primitive.weights) made.attributes["WEIGHTS_0"] = *primitive.weights;
    made.indices = primitive.indices;
    made.material = primitive.material;
    made.mode = TINYGLTF_MODE_TRIANGLES;
    tinygltf::Mesh mesh;
    mesh.name = name;
    mesh.primitives.push_back(std::move(made));
    return appended(model_->meshes, std::move(mesh));
}

int Document::add_skin(const std::vector<int>& joints, int inverse_bind_matrices, int skeleton_root) {
    tinygltf::Skin skin;
    skin.joints = joints;
    skin.inverseBindMatrices = inverse_bind_matrices;
    skin.skeleton = skeleton_root;
    return appended(model_->skins, std::move(skin));
}

void Document::add_animation(const std::string& name, int times, Interpolation interpolation,
                             const std::vector<Channel>& channels, const nlohmann::json& extras) {
    tinygltf::Animation animation;
    animation.name = name;
    animation.extras = to_value(extras);
    for (const Channel& channel : channels) {
        tinygltf::AnimationSampler sampler;
        sampler.input = times;
        sampler.output = channel.values;
        sampler.interpolation = interpolation == Interpolation::kStep ? "STEP" : "LINEAR";
        tinygltf::AnimationChannel made;
        made.sampler = appended(animation.samplers, std::move(sampler));
        made.target_node = channel.node;
        made.target_path = channel.path == Path::kRotation ? "rotation" : "scale";
        animation.channels.push_back(std::move(made));
    }
    model_->animations.push_back(std::move(animation));
}

void Document::set_node_extras(int node, const nlohmann::json& extras) { model_->node(node).extras = to_value(extras); }

void Document::set_asset_extras(const nlohmann::json& extras) { model_->asset.extras = to_value(extras); }

void Document::allocate() { model_->buffers.front().data.resize(model_->reserved_bytes); }

std::span<std::byte> Document::bytes(int accessor) {
    const tinygltf::Accessor& at = model_->accessor(accessor);
    const std::size_t component = at.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 2 : 4;
    const std::size_t size =
        at.count * component *
        static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(at.type)));
    const std::size_t start = model_->view(at.bufferView).byteOffset + at.byteOffset;
    return std::as_writable_bytes(std::span(model_->buffers.front().data)).subspan(start, size);
}

void Document::set_bounds(int accessor) {
    tinygltf::Accessor& at = model_->accessor(accessor);
    const std::span<const float> values = data<float>(accessor);
    const auto components =
        static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(at.type)));
    at.minValues.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(components));
    at.maxValues = at.minValues;
    for (std::size_t i = components; i < values.size(); ++i) {
        const auto value = static_cast<double>(values[i]);
        double& least = at.minValues[i % components];
        double& most = at.maxValues[i % components];
        least = std::min(least, value);
        most = std::max(most, value);
    }
}

std::string Document::write(Container container) const {
    std::string out;
    StringBuffer buffer(out);
    std::ostream stream(&buffer);
    stream.exceptions(std::ios::badbit);  // else a stream swallows std::bad_alloc, and half a file would be an answer
    tinygltf::TinyGLTF writer;
    if (container == Container::kGlb) out.reserve(model_->reserved_bytes + 64 * 1024);
    if (!writer.WriteGltfSceneToStream(model_.get(), stream, false, container == Container::kGlb))
        throw std::runtime_error("tinygltf refused to write");
    return out;
}

}  // namespace tuftwave::server::gltf
