#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <sstream>

#include "hair.hpp"

namespace afternoon {
namespace {

/// Appends the values to the buffer, with a view and an accessor of their own. @return  the accessor
template <class Value>
int add_data(tinygltf::Model& model, const std::vector<Value>& values, int component, int type, int target) {
    std::vector<unsigned char>& data = model.buffers[0].data;
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = values.size() * sizeof(Value);
    view.target = target;
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    data.insert(data.end(), bytes, bytes + view.byteLength);
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model.bufferViews.size());
    accessor.componentType = component;
    accessor.type = type;
    accessor.count = values.size();
    model.bufferViews.push_back(view);
    model.accessors.push_back(accessor);
    return static_cast<int>(model.accessors.size()) - 1;
}

tinygltf::Model empty_model() {
    tinygltf::Model model;
    model.asset.version = "2.0";
    model.buffers.emplace_back();
    model.scenes.emplace_back();
    model.defaultScene = 0;
    return model;
}

std::string file_of(const tinygltf::Model& model) {
    std::ostringstream out;
    tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, out, false, true);
    return out.str();
}

/// A chain's nodes, the root in the scene. @return  the root's index
int add_chain(tinygltf::Model& model, const Points& chain) {
    const auto root = static_cast<int>(model.nodes.size());
    model.scenes[0].nodes.push_back(root);
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const glm::vec3 from = i == 0 ? glm::vec3(0) : chain[i - 1], step = chain[i] - from;
        tinygltf::Node node;
        node.name = "bone" + std::to_string(model.nodes.size());
        node.translation = {static_cast<double>(step.x), static_cast<double>(step.y), static_cast<double>(step.z)};
        if (i + 1 < chain.size()) node.children.push_back(root + static_cast<int>(i) + 1);
        model.nodes.push_back(node);
    }
    return root;
}

}  // namespace

std::string mesh_file(const Mesh& mesh) {
    tinygltf::Model model = empty_model();
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    const int vertex = TINYGLTF_TARGET_ARRAY_BUFFER, element = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
    const int real = TINYGLTF_COMPONENT_TYPE_FLOAT, whole = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    primitive.attributes["POSITION"] = add_data(model, mesh.positions, real, TINYGLTF_TYPE_VEC3, vertex);
    glm::vec3 least = mesh.positions[0], most = least;
    for (const glm::vec3& position : mesh.positions) {
        least = glm::min(least, position);
        most = glm::max(most, position);
    }
    model.accessors.back().minValues = {static_cast<double>(least.x), static_cast<double>(least.y),
                                        static_cast<double>(least.z)};
    model.accessors.back().maxValues = {static_cast<double>(most.x), static_cast<double>(most.y),
                                        static_cast<double>(most.z)};
    primitive.attributes["NORMAL"] = add_data(model, mesh.normals, real, TINYGLTF_TYPE_VEC3, vertex);
    primitive.attributes["TEXCOORD_0"] = add_data(model, mesh.uvs, real, TINYGLTF_TYPE_VEC2, vertex);
    primitive.indices = add_data(model, mesh.indices, whole, TINYGLTF_TYPE_SCALAR, element);
    tinygltf::Material material;
    material.name = "hair";
    model.materials.push_back(material);
    primitive.material = 0;
    model.meshes.emplace_back();
    model.meshes[0].primitives.push_back(primitive);
    model.nodes.emplace_back();
    model.nodes[0].mesh = 0;
    model.scenes[0].nodes.push_back(0);
    return file_of(model);
}

std::string clip_file(const std::vector<Points>& chains, const Poses& poses, int hold, float fps) {
    tinygltf::Model model = empty_model();
    std::vector<float> times;  // the first picture once more at the end, so that the loop closes
    for (std::size_t n = 0; n <= poses.size(); ++n)
        times.push_back(static_cast<float>(n) * static_cast<float>(hold) / fps);
    const int input = add_data(model, times, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_SCALAR, 0);
    model.accessors[0].minValues = {static_cast<double>(times.front())};
    model.accessors[0].maxValues = {static_cast<double>(times.back())};
    tinygltf::Animation animation;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        const int root = add_chain(model, chains[c]);
        for (std::size_t i = 0; i + 1 < chains[c].size(); ++i) {
            std::vector<glm::vec4> keys;
            for (std::size_t n = 0; n <= poses.size(); ++n) {
                const glm::quat& q = poses[n % poses.size()][c][i];
                keys.emplace_back(q.x, q.y, q.z, q.w);
            }
            tinygltf::AnimationSampler sampler;
            sampler.input = input;
            sampler.output = add_data(model, keys, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC4, 0);
            sampler.interpolation = "STEP";
            tinygltf::AnimationChannel channel;
            channel.sampler = static_cast<int>(animation.samplers.size());
            channel.target_node = root + static_cast<int>(i);
            channel.target_path = "rotation";
            animation.samplers.push_back(sampler);
            animation.channels.push_back(channel);
        }
    }
    model.animations.push_back(animation);
    return file_of(model);
}

}  // namespace afternoon
