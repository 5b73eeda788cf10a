#include "character/own_vertices.hpp"

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "character/accessor.hpp"

namespace tuftwave::server::character {
namespace {

constexpr double kOwnWeight = 0.5;  // more than this, and no other joint can have as much

/// What takes a joint's vertices from the mesh to the model, at rest.
std::vector<Affine> bind_transforms(const FileValue& file, std::string_view binary, const Character& character,
                                    const Skin& skin) {
    std::vector<Affine> transforms;
    std::optional<AccessorView> matrices;
    if (skin.inverse_bind_matrices)
        matrices = AccessorView::open(file, static_cast<std::size_t>(*skin.inverse_bind_matrices), binary);
    const bool is_usable = matrices && matrices->width() == 16 && matrices->count() >= skin.joints.size();
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        const Affine& joint = character.nodes[static_cast<std::size_t>(skin.joints[j])].model;
        const auto column = [&](std::size_t i) {
            return Vec3{matrices->number(j, 4 * i), matrices->number(j, 4 * i + 1), matrices->number(j, 4 * i + 2)};
        };
        transforms.push_back(is_usable ? joint * Affine{column(0), column(1), column(2), column(3)} : joint);
    }
    return transforms;
}

/// The accessors of a primitive's positions, joints and weights.
using Accessors = std::array<int, 3>;

/// One primitive's skinned vertices; nothing if it has none that can be read.
struct SkinnedVertices {
    AccessorView positions, joints, weights;
};

std::optional<SkinnedVertices> open_vertices(const FileValue& file, std::string_view binary,
                                             const Accessors& accessors) {
    std::array<std::optional<AccessorView>, 3> views;
    for (std::size_t i = 0; i < 3; ++i) {
        views[i] = AccessorView::open(file, static_cast<std::size_t>(accessors[i]), binary);
        if (!views[i] || views[i]->width() != (i == 0 ? 3 : 4)) return {};
    }
    const std::size_t count = views[0]->count();
    if (views[1]->count() < count || views[2]->count() < count) return {};
    return SkinnedVertices{*views[0], *views[1], *views[2]};
}

void add_vertices(const SkinnedVertices& vertices, const Skin& skin, const std::vector<Affine>& transforms,
                  const Character& character, std::vector<OwnVertices>& found) {
    for (std::size_t v = 0; v < vertices.positions.count(); ++v) {
        for (std::size_t i = 0; i < 4; ++i) {
            const double joint = vertices.joints.number(v, i);
            const bool is_joint = joint >= 0 && joint < static_cast<double>(skin.joints.size());  // files may be signed
            if (!is_joint || !(vertices.weights.number(v, i) > kOwnWeight)) continue;
            const auto slot = static_cast<std::size_t>(joint);
            const auto node = static_cast<std::size_t>(skin.joints[slot]);
            const Vec3 place = transformed(
                transforms[slot],
                {vertices.positions.number(v, 0), vertices.positions.number(v, 1), vertices.positions.number(v, 2)});
            if (!is_finite(place)) continue;
            const double reach = length(place - character.nodes[node].model.origin);
            found[node].middle = found[node].middle + place;
            found[node].reach = std::max(found[node].reach, reach);
            ++found[node].count;
        }
    }
}

class Search {
  public:
    Search(const FileValue& file, std::string_view binary, const Character& character, std::size_t most)
        : file_(file),
          binary_(binary),
          character_(character),
          most_(most),
          accessors_(file["accessors"].size()),
          found_(character.nodes.size()) {}

    /// Each pair once, and all meshes of a skin before the next skin.
    /// @return  false once something is wrong
    bool add_mesh(int index, const FileValue& mesh, int mesh_index) {
        const Skin& skin = character_.skins[static_cast<std::size_t>(index)];
        if (skin.joints.empty()) return true;
        if (index != skin_) transforms_ = bind_transforms(file_, binary_, character_, skin);
        skin_ = index;
        for (const std::size_t number : primitives_of(mesh, mesh_index)) {
            Primitive& primitive = primitives_[number];
            const bool is_new = primitive.last_skin != index;
            vertices_ += is_new ? primitive.vertices.positions.count() : 1;  // looking at it again is not free either
            if (vertices_ > most_) {
                mesh.refuse(Fault::Kind::kTooMany, "at most " + std::to_string(most_) + " skinned vertices in all");
                return false;
            }
            primitive.last_skin = index;
            if (is_new) add_vertices(primitive.vertices, skin, transforms_, character_, found_);
        }
        return true;
    }

    std::vector<OwnVertices> finish() {
        for (OwnVertices& own : found_) {
            if (own.count > 0) own.middle = own.middle / static_cast<double>(own.count);
        }
        return std::move(found_);
    }

  private:
    /// Vertices that can be read; primitives often share them.
    struct Primitive {
        SkinnedVertices vertices;
        int last_skin = -1;  ///< that they were added for
    };

    /// Numbers of a mesh's readable primitives, each once. Many skins may wear the mesh, but it is read once.
    const std::vector<std::size_t>& primitives_of(const FileValue& mesh, int mesh_index) {
        const auto [place, is_new] = meshes_.try_emplace(mesh_index);
        if (!is_new) return place->second;
        const FileValue primitives = mesh["primitives"];
        std::set<std::size_t> numbers;
        for (std::size_t p = 0, count = primitives.size(); p < count; ++p) {
            if (const auto number = number_of(primitives.at(p)["attributes"])) numbers.insert(*number);
        }
        place->second.assign(numbers.begin(), numbers.end());
        return place->second;
    }

    std::optional<std::size_t> number_of(const FileValue& attributes) {
        const auto positions = attributes["POSITION"].index(accessors_),
                   joints = attributes["JOINTS_0"].index(accessors_),
                   weights = attributes["WEIGHTS_0"].index(accessors_);
        if (!positions || !joints || !weights) return {};
        const Accessors accessors{*positions, *joints, *weights};
        const auto [place, is_new] = numbers_.try_emplace(accessors);
        if (!is_new) return place->second;
        if (const auto vertices = open_vertices(file_, binary_, accessors)) {
            place->second = primitives_.size();
            primitives_.push_back({*vertices});
        }
        return place->second;
    }

    const FileValue& file_;
    const std::string_view binary_;
    const Character& character_;
    const std::size_t most_, accessors_;
    std::size_t vertices_ = 0;
    std::map<Accessors, std::optional<std::size_t>> numbers_;  // nothing where they cannot be read
    std::vector<Primitive> primitives_;
    std::map<int, std::vector<std::size_t>> meshes_;
    int skin_ = -1;
    std::vector<Affine> transforms_;  // of that skin
    std::vector<OwnVertices> found_;
};

}  // namespace

std::variant<std::vector<OwnVertices>, Fault> find_own_vertices(const FileJson& json, std::string_view binary,
                                                                const Character& character, std::size_t most_vertices) {
    std::optional<Fault> fault;
    const FileValue file(&json, "", fault);
    const FileValue nodes = file["nodes"], meshes = file["meshes"];
    Search search(file, binary, character, most_vertices);
    std::set<std::pair<int, int>> worn;  // skins and meshes; many nodes may share both
    for (std::size_t n = 0; n < character.nodes.size() && !fault; ++n) {
        const auto skin = nodes.at(n)["skin"].index(character.skins.size());
        const auto mesh = nodes.at(n)["mesh"].index(meshes.size());
        if (skin && mesh) worn.insert({*skin, *mesh});
    }
    for (const auto& [skin, mesh] : worn) {
        if (fault || !search.add_mesh(skin, meshes.at(static_cast<std::size_t>(mesh)), mesh)) break;
    }
    if (fault) return *std::move(fault);
    return search.finish();
}

}  // namespace tuftwave::server::character
