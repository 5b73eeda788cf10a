#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gltf/bounds.hpp"

namespace tuftwave::server::gltf {

/// How a document is packed: one binary file, or JSON with its buffer embedded.
enum class Container { kGlb, kGltf };

/// The bytes of a file, which do not begin where their memory does.
struct File {
    std::string memory;
    std::size_t first = 0;

    std::string_view bytes() const { return std::string_view(memory).substr(first); }
};

/// A glTF 2.0 document in the making. Its one buffer is written in place, and so is the file around it, since an answer
/// may have 100 MiB: there is never a second copy. Order of use: reserve views and accessors, allocate, fill, write
/// once.
class Document {
  public:
    enum class Purpose { kAttribute, kIndex, kData };  ///< what a view holds, which decides its target and stride
    enum class Component { kI8 = 5120, kU8 = 5121, kU16 = 5123, kU32 = 5125, kF32 = 5126 };
    enum class Shape { kScalar, kVec2, kVec3, kVec4, kMat4 };

    struct Accessor {
        int view = 0;
        std::size_t offset = 0;  ///< bytes into the view, a multiple of 4
        std::size_t count = 0;
        Component component = Component::kF32;
        Shape shape = Shape::kScalar;
        bool is_bounded = false;     ///< whether it is to have bounds, for which there must be room
        bool is_normalized = false;  ///< whether its whole numbers stand for 0..1 or -1..1
    };
    struct Node {
        std::string_view name;
        std::optional<std::array<double, 3>> translation;
        std::optional<std::array<double, 4>> rotation;  ///< x y z w
        std::optional<int> mesh, skin;
        std::optional<double> scale = std::nullopt;  ///< the same along all axes
    };
    struct Primitive {
        int positions, normals, uvs;  ///< accessors
        std::optional<int> joints, weights;
        int indices, material;
    };
    enum class Interpolation { kStep, kLinear };
    enum class Path { kRotation, kScale };
    struct Channel {
        int node, values;  ///< a node, and the accessor of its keys
        Path path = Path::kRotation;
    };

    explicit Document(const std::string& generator);
    ~Document();
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    /// @param stride  bytes per element of an attribute view
    int add_view(Purpose purpose, std::size_t bytes, std::size_t stride = 0);
    int add_accessor(const Accessor& accessor);
    /// Makes room for what is about to be added.
    void expect(std::size_t nodes, std::size_t accessors);
    /// @param parent  a node that is there already
    int add_node(const Node& node, std::optional<int> parent = std::nullopt);
    void add_to_scene(int node);
    int add_material(const std::string& name, std::array<double, 3> linear_color);
    int add_mesh(const std::string& name, const Primitive& primitive);
    int add_skin(const std::vector<int>& joints, int inverse_bind_matrices, int skeleton_root);
    void add_animation(const std::string& name, int times, Interpolation interpolation, std::vector<Channel> channels,
                       const nlohmann::json& extras);
    void set_node_extras(int node, const nlohmann::json& extras);
    void set_asset_extras(std::string extras);  ///< @param extras  an object's text

    /// Makes the buffer; call once, when all but bounds is said. Whatever it holds then must be written over.
    /// @param container  that it will be written as
    void allocate(Container container);
    /// The bytes of an accessor.
    std::span<std::byte> bytes(int accessor);
    template <class T>
    std::span<T> data(int accessor) {
        const std::span<std::byte> raw = bytes(accessor);
        return {reinterpret_cast<T*>(raw.data()), raw.size() / sizeof(T)};
    }
    /// Says the bounds of an accessor, if it is to have some; of one of single float32 numbers, they are found.
    void set_bounds(int accessor, const Bounds& bounds);
    void set_bounds(int accessor);

    /// The file. @param container  as given to allocate()
    File write(Container container);

    struct Model;
    /// What it says and holds once it is filled, for whoever writes it in another form.
    Model& model() { return *model_; }

  private:
    File write_glb();
    File write_gltf();

    std::unique_ptr<Model> model_;
};

}  // namespace tuftwave::server::gltf
