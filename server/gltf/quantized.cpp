#include "gltf/quantized.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "gltf/packed_vertices.hpp"
#include "memory/buffers.hpp"

namespace tuftwave::server::gltf {
namespace {

using Component = Document::Component;
using Model = Document::Model;

constexpr std::size_t kRun = 8192;       // vertices that are a job
constexpr std::size_t kFewJoints = 256;  // that a byte tells apart

/// What a view's elements are to be.
struct Form {
    std::size_t stride;
    Component component;
    bool is_normalized;
};

/// Vertices of a mesh.
struct Run {
    std::size_t mesh, first, count;
};

class Quantizer {
  public:
    explicit Quantizer(Model& model)
        : model_(model), plain_(model.accessors), forms_(model.views.size()), boxes_(plain_.size()) {
        for (const Model::View& view : model.views)
            made_.views.push_back(
                std::as_bytes(std::span(model.memory)).subspan(model.first + view.offset, view.bytes));
        plain_views_ = made_.views;
    }

    Quantized run(const ForEach& for_each, const std::stop_token& stop) {
        choose_forms();
        make_room();
        for (Model::Bounded& bounds : model_.bounds) boxes_[place(bounds.accessor)] = &bounds;
        for (const Model::Mesh& mesh : model_.meshes) grids_.push_back(grid_around(mesh.primitive.positions));
        const std::vector<Run> runs = split();
        for_each(runs.size(), [&](std::size_t i) {
            if (!stop.stop_requested()) fill(runs[i]);
        });
        for (std::size_t i = 0; i < grids_.size(); ++i) carry_back(i);
        return std::move(made_);
    }

  private:
    static std::size_t place(int index) { return static_cast<std::size_t>(index); }

    void choose_forms() {
        const bool are_few =
            std::ranges::all_of(model_.skins, [](const Model::Skin& skin) { return skin.joints.size() <= kFewJoints; });
        for (const Model::Mesh& mesh : model_.meshes) {
            reshape(mesh.primitive.positions, {8, Component::kU16, true});
            reshape(mesh.primitive.normals, {4, Component::kI8, true});
            reshape(mesh.primitive.uvs, {4, Component::kU16, true});
            if (!mesh.skin) continue;
            reshape(*mesh.primitive.joints, are_few ? Form{4, Component::kU8, false} : Form{8, Component::kU16, false});
            reshape(*mesh.primitive.weights, {4, Component::kU8, true});
        }
    }

    void reshape(int accessor, const Form& form) {
        Document::Accessor& changed = model_.accessors[place(accessor)];
        changed.offset = changed.offset / model_.views[place(changed.view)].stride * form.stride;
        changed.component = form.component;
        changed.is_normalized = form.is_normalized;
        forms_[place(changed.view)] = form;
    }

    void make_room() {
        std::size_t bytes = 0;
        for (std::size_t i = 0; i < forms_.size(); ++i) {
            if (!forms_[i]) continue;
            Model::View& view = model_.views[i];
            view.bytes = view.bytes / view.stride * forms_[i]->stride;
            view.stride = forms_[i]->stride;
            view.offset = bytes;
            bytes += view.bytes;
        }
        made_.memory = memory::take_buffer(bytes, bytes);
        for (std::size_t i = 0; i < forms_.size(); ++i) {
            const Model::View& view = model_.views[i];
            if (forms_[i]) made_.views[i] = std::as_bytes(std::span(made_.memory)).subspan(view.offset, view.bytes);
        }
    }

    Grid grid_around(int positions) {
        Bounds& box = boxes_[place(positions)]->box;
        const Grid grid = grid_of(box);
        for (auto* const corner : {&box.least, &box.most}) {
            std::array<std::uint16_t, 4> packed{};
            pack_positions(*corner, grid, packed);
            std::copy_n(packed.begin(), corner->size(), corner->begin());
        }
        return grid;
    }

    std::vector<Run> split() const {
        std::vector<Run> runs;
        for (std::size_t mesh = 0; mesh < model_.meshes.size(); ++mesh) {
            const std::size_t count = plain_[place(model_.meshes[mesh].primitive.positions)].count;
            for (std::size_t first = 0; first < count; first += kRun)
                runs.push_back({mesh, first, std::min(kRun, count - first)});
        }
        return runs;
    }

    void fill(const Run& run) {
        const Document::Primitive& mesh = model_.meshes[run.mesh].primitive;
        pack_positions(from<float>(mesh.positions, run), grids_[run.mesh], to<std::uint16_t>(mesh.positions, run));
        pack_normals(from<float>(mesh.normals, run), to<std::int8_t>(mesh.normals, run));
        pack_uvs(from<float>(mesh.uvs, run), to<std::uint16_t>(mesh.uvs, run));
        if (!mesh.joints) return;
        const auto joints = from<std::uint16_t>(*mesh.joints, run);
        if (model_.accessors[place(*mesh.joints)].component == Component::kU8) {
            pack_joints(joints, to<std::uint8_t>(*mesh.joints, run));
        } else {
            std::ranges::copy(joints, to<std::uint16_t>(*mesh.joints, run).begin());
        }
        pack_weights(from<float>(*mesh.weights, run), to<std::uint8_t>(*mesh.weights, run));
    }

    template <class T>
    std::span<const T> from(int accessor, const Run& run) const {
        const Document::Accessor& plain = plain_[place(accessor)];
        const std::size_t width = width_of(plain.shape);
        const std::byte* const start = plain_views_[place(plain.view)].data() + plain.offset;
        return std::span(reinterpret_cast<const T*>(start), plain.count * width)
            .subspan(run.first * width, run.count * width);
    }

    template <class T>
    std::span<T> to(int accessor, const Run& run) {
        const Document::Accessor& packed = model_.accessors[place(accessor)];
        const Model::View& view = model_.views[place(packed.view)];
        const std::size_t width = view.stride / sizeof(T);
        char* const start = made_.memory.data() + view.offset + packed.offset;
        return std::span(reinterpret_cast<T*>(start), packed.count * width)
            .subspan(run.first * width, run.count * width);
    }

    void carry_back(std::size_t index) {
        const Model::Mesh& mesh = model_.meshes[index];
        const Grid& grid = grids_[index];
        const std::array<double, 3> origin{grid.origin[0], grid.origin[1], grid.origin[2]};
        const double edge = grid.edge;
        if (mesh.skin) return carry_back(model_.skins[place(*mesh.skin)].matrices, origin, edge);
        Model::Placed& node = model_.nodes[place(mesh.node)];
        node.members = model_.add_members({mesh.name, origin, {}, static_cast<int>(index), {}, edge});
    }

    /// Puts what carries positions back before each of a skin's matrices.
    void carry_back(int accessor, const std::array<double, 3>& origin, double edge) {
        const Document::Accessor& matrices = model_.accessors[place(accessor)];
        const std::size_t start = model_.first + model_.views[place(matrices.view)].offset + matrices.offset;
        auto* const columns = reinterpret_cast<float*>(model_.memory.data() + start);
        for (std::size_t i = 0; i < matrices.count; ++i) {
            for (std::size_t row = 0; row < 3; ++row) {
                float* const at = columns + 16 * i + row;
                double moved = at[12];
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double turned = at[4 * axis];
                    moved += turned * origin[axis];
                    at[4 * axis] = static_cast<float>(turned * edge);
                }
                at[12] = static_cast<float>(moved);
            }
        }
    }

    Model& model_;
    const std::vector<Document::Accessor> plain_;
    std::vector<std::span<const std::byte>> plain_views_;
    std::vector<std::optional<Form>> forms_;  // of the views that hold vertices
    std::vector<Model::Bounded*> boxes_;      // of accessors
    std::vector<Grid> grids_;                 // of meshes
    Quantized made_;
};

}  // namespace

Quantized quantize(Model& model, const ForEach& for_each, const std::stop_token& stop) {
    return Quantizer(model).run(for_each, stop);
}

}  // namespace tuftwave::server::gltf
