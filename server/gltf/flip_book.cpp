#include "gltf/flip_book.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "gltf/index_type.hpp"
#include "gltf/names.hpp"
#include "tuftwave/skinning.hpp"

namespace tuftwave::server::gltf {
namespace {

using Component = Document::Component;
using Purpose = Document::Purpose;
using Shape = Document::Shape;

}  // namespace

FlipBook::FlipBook(Document& document, const HairPlan& plan, ClipKeys keys, int material, const nlohmann::json& extras)
    : document_(document), plan_(plan), keys_(std::move(keys)) {
    const int root = document.add_node({"hair_root", {}, {}, {}, {}});
    document.add_to_scene(root);
    reserve_shared();
    reserve_pages(root, material);
    std::vector<Document::Channel> channels;
    for (const Page& page : pages_) channels.push_back({page.node, page.scales, Document::Path::kScale});
    const auto between = keys_.is_stepped ? Document::Interpolation::kStep : Document::Interpolation::kLinear;
    document.add_animation("wave", times_, between, channels, extras);
}

void FlipBook::reserve_shared() {
    const bool is_short = fits_short(plan_.vertices);
    uvs_ = document_.add_accessor({document_.add_view(Purpose::kAttribute, plan_.vertices * 8, 8), 0, plan_.vertices,
                                   Component::kF32, Shape::kVec2});
    indices_ = document_.add_accessor({document_.add_view(Purpose::kIndex, plan_.indices * (is_short ? 2 : 4)), 0,
                                       plan_.indices, is_short ? Component::kU16 : Component::kU32, Shape::kScalar});
    times_ = document_.add_accessor({document_.add_view(Purpose::kData, keys_.times.size() * sizeof(float)), 0,
                                     keys_.times.size(), Component::kF32, Shape::kScalar, true});
}

void FlipBook::reserve_pages(int root, int material) {
    const auto pictures = static_cast<std::size_t>(plan_.motion->schedule.pictures);
    const std::size_t bytes = plan_.vertices * 12, scale_bytes = keys_.times.size() * 12;
    const int positions = document_.add_view(Purpose::kAttribute, pictures * bytes, 12);
    const int normals = document_.add_view(Purpose::kAttribute, pictures * bytes, 12);
    const int scales = document_.add_view(Purpose::kData, pictures * scale_bytes);
    for (std::size_t n = 0; n < pictures; ++n) {
        const auto vectors = [&](int view, std::size_t size, std::size_t count) {
            return document_.add_accessor({view, n * size, count, Component::kF32, Shape::kVec3, view == positions});
        };
        Page page{0, vectors(positions, bytes, plan_.vertices), vectors(normals, bytes, plan_.vertices),
                  vectors(scales, scale_bytes, keys_.times.size())};
        const std::string name = Names::joint("picture", n + 1);
        const int mesh = document_.add_mesh(name, {page.positions, page.normals, uvs_, {}, {}, indices_, material});
        // Where no clip is played, the first picture alone is to be seen.
        page.node = document_.add_node({name, {}, {}, mesh, {}, n == 0 ? 1.0 : 0.0}, root);
        pages_.push_back(page);
    }
}

void FlipBook::fill(const ForEach& for_each, const std::stop_token& stop) {
    std::vector<std::pair<std::size_t, std::size_t>> starts;  // a tuft's first vertex and index
    std::size_t vertex = 0, index = 0;
    for (const MeshPlan& tuft : plan_.tufts) {
        starts.emplace_back(vertex, index);
        vertex += tuft.vertex_count();
        index += tuft.index_count();
    }
    for_each(plan_.tufts.size(), [&](std::size_t i) {
        if (!stop.stop_requested()) fill_tuft(i, starts[i].first, starts[i].second);
    });
    std::ranges::copy(keys_.times, document_.data<float>(times_).begin());
    document_.set_bounds(times_);
    fill_scales();
    for (const Page& page : pages_)
        document_.set_bounds(page.positions, bounds_of(document_.data<float>(page.positions)));
}

void FlipBook::fill_tuft(std::size_t tuft, std::size_t first_vertex, std::size_t first_index) {
    const MeshPlan& plan = plan_.tufts[tuft];
    const Mesh rest = to_mesh(plan);
    const std::size_t count = plan.vertex_count(), nodes = plan_.chains[tuft].nodes.size();
    std::ranges::copy(rest.uvs, document_.data<float>(uvs_).subspan(2 * first_vertex).begin());
    const auto offset = static_cast<std::uint32_t>(first_vertex);
    if (fits_short(plan_.vertices)) {
        write_indices(plan, document_.data<std::uint16_t>(indices_).subspan(first_index, plan.index_count()), offset);
    } else {
        write_indices(plan, document_.data<std::uint32_t>(indices_).subspan(first_index, plan.index_count()), offset);
    }
    const std::span<const Quat> rotations = plan_.motion->chains[tuft].rotations;
    for (std::size_t n = 0; n < pages_.size(); ++n) {
        const auto vectors = [&](int accessor) {
            return document_.data<float>(accessor).subspan(3 * first_vertex, 3 * count);
        };
        write_posed_vertices(rest, plan_.chains[tuft], rotations.subspan(n * nodes, nodes),
                             vectors(pages_[n].positions), vectors(pages_[n].normals));
    }
}

void FlipBook::fill_scales() {
    for (std::size_t n = 0; n < pages_.size(); ++n) {
        const std::span<float> scales = document_.data<float>(pages_[n].scales);
        for (std::size_t key = 0; key < keys_.pictures.size(); ++key)
            std::ranges::fill(scales.subspan(3 * key, 3), keys_.pictures[key] == n ? 1.0F : 0.0F);
    }
}

}  // namespace tuftwave::server::gltf
