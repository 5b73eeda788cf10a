#include "character/own_vertices.hpp"

#include <array>
#include <cmath>
#include <set>
#include <tuple>

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

/// One primitive's skinned vertices; nothing if it has none that can be read.
struct SkinnedVertices {
    AccessorView positions, joints, weights;
};

std::optional<SkinnedVertices> open_vertices(const FileValue& file, std::string_view binary,
                                             const std::array<int, 3>& accessors) {
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
            if (!(vertices.weights.number(v, i) > kOwnWeight) || !(joint < static_cast<double>(skin.joints.size())))
                continue;
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
          transforms_(character.skins.size()),
          found_(character.nodes.size()) {}

    /// @return  false once something is wrong
    bool add_mesh(int skin, const FileValue& mesh) {
        const FileValue primitives = mesh["primitives"];
        for (std::size_t p = 0, count = primitives.size(); p < count; ++p) {
            if (!add_primitive(skin, primitives.at(p))) return false;
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
    bool add_primitive(int skin, const FileValue& primitive) {
        const FileValue attributes = primitive["attributes"];
        const auto positions = attributes["POSITION"].index(accessors_),
                   joints = attributes["JOINTS_0"].index(accessors_),
                   weights = attributes["WEIGHTS_0"].index(accessors_);
        if (!positions || !joints || !weights) return true;
        if (!seen_.insert({skin, {*positions, *joints, *weights}}).second) return true;
        const auto vertices = open_vertices(file_, binary_, {*positions, *joints, *weights});
        if (!vertices) return true;
        vertices_ += vertices->positions.count();
        if (vertices_ > most_) {
            primitive.refuse(Fault::Kind::kTooMany, "at most " + std::to_string(most_) + " skinned vertices in all");
            return false;
        }
        const auto slot = static_cast<std::size_t>(skin);
        if (transforms_[slot].empty())
            transforms_[slot] = bind_transforms(file_, binary_, character_, character_.skins[slot]);
        add_vertices(*vertices, character_.skins[slot], transforms_[slot], character_, found_);
        return true;
    }

    const FileValue& file_;
    const std::string_view binary_;
    const Character& character_;
    const std::size_t most_, accessors_;
    std::size_t vertices_ = 0;
    std::set<std::tuple<int, std::array<int, 3>>> seen_;  // primitives often share their vertices
    std::vector<std::vector<Affine>> transforms_;         // of each skin, once it is needed
    std::vector<OwnVertices> found_;
};

}  // namespace

std::variant<std::vector<OwnVertices>, Fault> find_own_vertices(const FileJson& json, std::string_view binary,
                                                                const Character& character, std::size_t most_vertices) {
    std::optional<Fault> fault;
    const FileValue file(&json, "", fault);
    const FileValue nodes = file["nodes"], meshes = file["meshes"];
    Search search(file, binary, character, most_vertices);
    for (std::size_t n = 0; n < character.nodes.size() && !fault; ++n) {
        const auto skin = nodes.at(n)["skin"].index(character.skins.size());
        const auto mesh = nodes.at(n)["mesh"].index(meshes.size());
        if (skin && mesh && !search.add_mesh(*skin, meshes.at(static_cast<std::size_t>(*mesh)))) break;
    }
    if (fault) return *std::move(fault);
    return search.finish();
}

}  // namespace tuftwave::server::character
