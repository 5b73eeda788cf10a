#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "gltf/document.hpp"
#include "gltf/skeleton_nodes.hpp"
#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server::gltf {

/// The meshes of a hair file: reserved first, then written in place once the document's buffer is made.
class HairMeshes {
  public:
    /// @param is_packed  whether triangles are to be in the order that packs best
    HairMeshes(Document& document, const HairPlan& plan, bool is_packed);

    /// Each tuft on its own; tufts of one shape share their triangles.
    void reserve_per_tuft(const std::vector<std::string>& names, const SkeletonNodes* skeleton, int material);

    /// All tufts as one mesh with one skin. @param skeleton  null where nothing hangs on bones
    void reserve_merged(const SkeletonNodes* skeleton, int material);

    /// Writes every vertex, triangle and bind matrix; call after document.allocate(). Leaves tufts out once `stop` is
    /// set.
    void fill(const ForEach& for_each, const std::stop_token& stop);

  private:
    struct Part {
        int positions, normals, uvs, indices;  // accessors
        std::optional<int> joints, weights;
    };
    struct Start {
        std::size_t part, vertex, index, joint;  // vertex, index and joint count within the part
    };
    using Shape = std::tuple<std::size_t, int, bool>;  // rings, sides, flat tip: what the triangles depend on

    std::map<Shape, int> reserve_shared_indices();
    void add_part(std::size_t first_vertex, std::size_t count, int indices);
    int add_skin(const std::vector<int>& joints, int view, std::size_t first_joint, int root);
    void add_mesh_node(const std::string& name, std::optional<int> skin, int material, const std::string& given_name);
    std::vector<Start> tuft_starts() const;
    Bounds fill_tuft(std::size_t tuft, const Start& start);
    void set_bounds(std::span<const Start> starts, std::span<const Bounds> bounds);
    void fill_indices(const MeshPlan& tuft, int accessor, std::size_t first_index, std::size_t first_vertex);

    Document& document_;
    const HairPlan& plan_;
    bool has_skin_, is_packed_;
    int positions_, normals_, uvs_, joints_ = -1, weights_ = -1;  // views
    bool is_merged_ = false;
    std::vector<Part> parts_;
    std::vector<int> matrices_;                                  // accessors
    std::vector<std::pair<const MeshPlan*, int>> index_owners_;  // one tuft per shape, and its accessor
};

}  // namespace tuftwave::server::gltf
