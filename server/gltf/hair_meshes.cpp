#include "gltf/hair_meshes.hpp"

#include <array>
#include <functional>
#include <nlohmann/json.hpp>

#include "gltf/bounds.hpp"
#include "gltf/index_type.hpp"
#include "gltf/packed_order.hpp"

namespace tuftwave::server::gltf {
namespace {

using Component = Document::Component;
using Purpose = Document::Purpose;

constexpr std::size_t kMatrixBytes = 64;

void fill_matrices(const Chain& chain, std::span<float> out) {
    Quat global = normalized(chain.parent_rotation);
    for (std::size_t i = 0; i + 1 < chain.nodes.size(); ++i) {
        global = global * normalized(chain.rest_rotations[i]);
        const std::array<double, 16> matrix = inverse_rigid_matrix(global, chain.nodes[i]);
        for (std::size_t k = 0; k < 16; ++k) out[16 * i + k] = static_cast<float>(matrix[k]);
    }
}

}  // namespace

HairMeshes::HairMeshes(Document& document, const HairPlan& plan, bool is_packed)
    : document_(document),
      plan_(plan),
      has_skin_(plan.hairstyle->mesh.skin),
      is_packed_(is_packed),
      positions_(document.add_view(Purpose::kAttribute, plan.vertices * 12, 12)),
      normals_(document.add_view(Purpose::kAttribute, plan.vertices * 12, 12)),
      uvs_(document.add_view(Purpose::kAttribute, plan.vertices * 8, 8)) {
    if (!has_skin_) return;
    joints_ = document.add_view(Purpose::kAttribute, plan.vertices * 8, 8);
    weights_ = document.add_view(Purpose::kAttribute, plan.vertices * 16, 16);
}

void HairMeshes::reserve_per_tuft(const std::vector<std::string>& names, const SkeletonNodes* skeleton, int material) {
    const std::map<Shape, int> triangles = reserve_shared_indices();
    const int matrices = has_skin_ ? document_.add_view(Purpose::kData, plan_.joints * kMatrixBytes) : -1;
    std::size_t first_vertex = 0, first_joint = 0;
    for (std::size_t i = 0; i < plan_.tufts.size(); ++i) {
        const MeshPlan& tuft = plan_.tufts[i];
        add_part(first_vertex, tuft.vertex_count(), triangles.at({tuft.ring_count, tuft.sides, tuft.flat_tip}));
        std::optional<int> skin;
        if (has_skin_) skin = add_skin(skeleton->chains()[i].joints, matrices, first_joint, skeleton->root());
        add_mesh_node(names[i], skin, material, plan_.chains[i].name);
        first_vertex += tuft.vertex_count();
        first_joint += static_cast<std::size_t>(tuft.joints);
    }
}

void HairMeshes::reserve_merged(const SkeletonNodes* skeleton, int material) {
    is_merged_ = true;
    const bool is_short = fits_short(plan_.vertices);
    const int view = document_.add_view(Purpose::kIndex, plan_.indices * (is_short ? 2 : 4));
    const int indices = document_.add_accessor(
        {view, 0, plan_.indices, is_short ? Component::kU16 : Component::kU32, Document::Shape::kScalar});
    add_part(0, plan_.vertices, indices);
    if (!has_skin_) return add_mesh_node("hair", {}, material, "");
    const int matrices = document_.add_view(Purpose::kData, plan_.joints * kMatrixBytes);
    std::vector<int> joints;
    for (const ChainNodes& chain : skeleton->chains())
        joints.insert(joints.end(), chain.joints.begin(), chain.joints.end());
    add_mesh_node("hair", add_skin(joints, matrices, 0, skeleton->root()), material, "");
}

std::map<HairMeshes::Shape, int> HairMeshes::reserve_shared_indices() {
    std::map<Shape, int> accessors;
    std::vector<Document::Accessor> wanted;
    std::size_t bytes = 0;
    for (const MeshPlan& tuft : plan_.tufts) {
        const int next = static_cast<int>(wanted.size());
        if (!accessors.emplace(Shape{tuft.ring_count, tuft.sides, tuft.flat_tip}, next).second) continue;
        const bool is_short = fits_short(tuft.vertex_count());
        wanted.push_back(
            {0, bytes, tuft.index_count(), is_short ? Component::kU16 : Component::kU32, Document::Shape::kScalar});
        index_owners_.emplace_back(&tuft, next);
        bytes += (tuft.index_count() * (is_short ? 2 : 4) + 3) / 4 * 4;
    }
    const int view = document_.add_view(Purpose::kIndex, bytes);
    std::vector<int> made;
    for (Document::Accessor& accessor : wanted) {
        accessor.view = view;
        made.push_back(document_.add_accessor(accessor));
    }
    for (auto& [shape, accessor] : accessors) accessor = made[static_cast<std::size_t>(accessor)];
    for (auto& [tuft, accessor] : index_owners_) accessor = made[static_cast<std::size_t>(accessor)];
    return accessors;
}

void HairMeshes::add_part(std::size_t first_vertex, std::size_t count, int indices) {
    const auto accessor = [&](int view, std::size_t stride, Component component, Document::Shape shape) {
        return document_.add_accessor({view, first_vertex * stride, count, component, shape, view == positions_});
    };
    Part& part = parts_.emplace_back();
    part.positions = accessor(positions_, 12, Component::kF32, Document::Shape::kVec3);
    part.normals = accessor(normals_, 12, Component::kF32, Document::Shape::kVec3);
    part.uvs = accessor(uvs_, 8, Component::kF32, Document::Shape::kVec2);
    part.indices = indices;
    if (!has_skin_) return;
    part.joints = accessor(joints_, 8, Component::kU16, Document::Shape::kVec4);
    part.weights = accessor(weights_, 16, Component::kF32, Document::Shape::kVec4);
}

int HairMeshes::add_skin(const std::vector<int>& joints, int view, std::size_t first_joint, int root) {
    matrices_.push_back(document_.add_accessor(
        {view, first_joint * kMatrixBytes, joints.size(), Component::kF32, Document::Shape::kMat4}));
    return document_.add_skin(joints, matrices_.back(), root);
}

void HairMeshes::add_mesh_node(const std::string& name, std::optional<int> skin, int material,
                               const std::string& given_name) {
    const Part& part = parts_.back();
    const int mesh = document_.add_mesh(
        name, {part.positions, part.normals, part.uvs, part.joints, part.weights, part.indices, material});
    const int node = document_.add_node({name, {}, {}, mesh, skin});
    document_.add_to_scene(node);
    if (!given_name.empty() && given_name != name) document_.set_node_extras(node, {{"name", given_name}});
}

std::vector<HairMeshes::Start> HairMeshes::tuft_starts() const {
    std::vector<Start> starts;
    starts.reserve(plan_.tufts.size());
    Start next{};
    for (const MeshPlan& tuft : plan_.tufts) {
        starts.push_back(next);
        if (is_merged_) {
            next.vertex += tuft.vertex_count();
            next.index += tuft.index_count();
            next.joint += static_cast<std::size_t>(tuft.joints);
        } else {
            ++next.part;
        }
    }
    return starts;
}

void HairMeshes::fill(const ForEach& for_each, const std::stop_token& stop) {
    const std::vector<Start> starts = tuft_starts();
    std::vector<Bounds> bounds(starts.size());
    const auto fill_one = [&](std::size_t i) {
        if (!stop.stop_requested()) bounds[i] = fill_tuft(i, starts[i]);
    };
    for_each(starts.size(), std::cref(fill_one));  // which needs no memory of its own
    for (const auto& [tuft, accessor] : index_owners_) fill_indices(*tuft, accessor, 0, 0);
    set_bounds(starts, bounds);
}

void HairMeshes::set_bounds(std::span<const Start> starts, std::span<const Bounds> bounds) {
    for (std::size_t i = 0; i < starts.size();) {
        Bounds whole = bounds[i];
        const std::size_t part = starts[i].part;
        for (++i; i < starts.size() && starts[i].part == part; ++i) whole.include(bounds[i]);
        document_.set_bounds(parts_[part].positions, whole);
    }
}

Bounds HairMeshes::fill_tuft(std::size_t tuft, const Start& start) {
    MeshPlan made;
    const MeshPlan& mesh = mesh_plan(plan_, tuft, made);
    const Part& part = parts_[start.part];
    const std::size_t count = mesh.vertex_count();
    const auto floats = [&](int accessor, std::size_t width) {
        return document_.data<float>(accessor).subspan(width * start.vertex, width * count);
    };
    MeshSpans spans{floats(part.positions, 3), floats(part.normals, 3), floats(part.uvs, 2), {}, {}};
    if (has_skin_) {
        spans.joints = document_.data<std::uint16_t>(*part.joints).subspan(4 * start.vertex, 4 * count);
        spans.weights = floats(*part.weights, 4);
        spans.first_joint = static_cast<std::uint16_t>(start.joint);
        fill_matrices(plan_.chains[tuft], document_.data<float>(matrices_[start.part]).subspan(16 * start.joint));
    }
    write_vertices(mesh, spans);
    if (is_merged_) fill_indices(mesh, part.indices, start.index, start.vertex);
    return bounds_of(spans.positions);
}

void HairMeshes::fill_indices(const MeshPlan& tuft, int accessor, std::size_t first_index, std::size_t first_vertex) {
    const auto offset = static_cast<std::uint32_t>(first_vertex);
    const std::size_t count = tuft.index_count();
    const auto write = [&](auto indices) {
        const auto triangles = indices.subspan(first_index, count);
        write_indices(tuft, triangles, offset);
        if (is_packed_) order_for_packing(triangles, tuft.sides);
    };
    if (fits_short(is_merged_ ? plan_.vertices : tuft.vertex_count())) {
        write(document_.data<std::uint16_t>(accessor));
    } else {
        write(document_.data<std::uint32_t>(accessor));
    }
}

}  // namespace tuftwave::server::gltf
