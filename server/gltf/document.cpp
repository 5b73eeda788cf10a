#include "gltf/document.hpp"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "gltf/model.hpp"
#include "memory/buffers.hpp"

namespace tuftwave::server::gltf {
namespace {

constexpr std::size_t kStart = 64;  // bytes that the buffer's place in memory is a multiple of

std::size_t base64_bytes(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

template <class Items, class Item>
int appended(Items& items, Item&& item) {
    items.push_back(std::forward<Item>(item));
    return static_cast<int>(items.size()) - 1;
}

/// Text in place of bytes. The bytes may stand within the text's room if they are the last of it: what is written never
/// passes what is yet to be read.
void write_base64(const unsigned char* from, std::size_t bytes, char* to) {
    static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned char* const end = from + bytes;
    while (from != end) {
        const std::size_t part = std::min<std::size_t>(3, static_cast<std::size_t>(end - from));
        const unsigned a = from[0], b = part > 1 ? from[1] : 0, c = part > 2 ? from[2] : 0;
        from += part;
        *to++ = kDigits[a >> 2];
        *to++ = kDigits[(a & 3) << 4 | b >> 4];
        *to++ = part > 1 ? kDigits[(b & 15) << 2 | c >> 6] : '=';
        *to++ = part > 2 ? kDigits[c & 63] : '=';
    }
}

}  // namespace

Document::Document(const std::string& generator) : model_(std::make_unique<Model>()) {
    constexpr std::size_t kUsual = 8;  // views, and accessors of one mesh
    model_->generator = generator;
    model_->views.reserve(kUsual);
    model_->accessors.reserve(kUsual);
}

Document::~Document() = default;

int Document::add_view(Purpose purpose, std::size_t bytes, std::size_t stride) {
    const std::size_t offset = model_->bytes;
    model_->bytes += aligned(bytes);
    return appended(model_->views, Model::View{purpose, offset, bytes, stride});
}

int Document::add_accessor(const Accessor& accessor) { return appended(model_->accessors, accessor); }

void Document::expect(std::size_t nodes, std::size_t accessors) {
    constexpr std::size_t kUsualText = 128;  // bytes of a node's
    model_->nodes.reserve(model_->nodes.size() + nodes);
    model_->texts.reserve(model_->texts.size() + nodes * kUsualText);
    model_->accessors.reserve(model_->accessors.size() + accessors);
}

int Document::add_node(const Node& node, std::optional<int> parent) {
    const int added = appended(model_->nodes, Model::Placed{parent, model_->add_members(node)});
    if (node.mesh) {
        Model::Mesh& mesh = model_->meshes[static_cast<std::size_t>(*node.mesh)];
        mesh.node = added;
        mesh.skin = node.skin;
    }
    return added;
}

void Document::add_to_scene(int node) { model_->roots.push_back(node); }

int Document::add_material(const std::string& name, std::array<double, 3> linear_color) {
    return appended(model_->materials, Model::Material{name, linear_color});
}

int Document::add_mesh(const std::string& name, const Primitive& primitive) {
    return appended(model_->meshes, Model::Mesh{name, primitive});
}

int Document::add_skin(const std::vector<int>& joints, int inverse_bind_matrices, int skeleton_root) {
    return appended(model_->skins, Model::Skin{joints, inverse_bind_matrices, skeleton_root});
}

void Document::add_animation(const std::string& name, int times, Interpolation interpolation,
                             std::vector<Channel> channels, const nlohmann::json& extras) {
    model_->animations.push_back({name, times, interpolation, std::move(channels), extras_text(extras)});
}

void Document::set_node_extras(int node, const nlohmann::json& extras) {
    model_->nodes[static_cast<std::size_t>(node)].extras = model_->add_text(extras_text(extras));
}

void Document::set_asset_extras(std::string extras) { model_->extras = std::move(extras); }

void Document::allocate(Container container) {
    const bool is_text = container == Container::kGltf;
    const std::size_t text = most_json_bytes(*model_);
    // What stands before the buffer ends where the buffer begins, however long it is: it is never moved.
    model_->first = is_text ? 0 : (kGlbHeads + text + kStart - 1) / kStart * kStart;
    const std::size_t end = model_->first + model_->bytes;
    model_->memory = memory::take_buffer(end, is_text ? base64_bytes(model_->bytes) + text + 1 : end);
    for (const Model::View& view : model_->views) {
        char* const data = model_->memory.data() + model_->first + view.offset;
        std::fill(data + view.bytes, data + aligned(view.bytes), '\0');
    }
}

std::span<std::byte> Document::bytes(int accessor) {
    const Accessor& at = model_->accessors[static_cast<std::size_t>(accessor)];
    const std::size_t size = at.count * size_of(at.component) * width_of(at.shape);
    const std::size_t start = model_->views[static_cast<std::size_t>(at.view)].offset + at.offset;
    return std::as_writable_bytes(std::span(model_->memory)).subspan(model_->first + start, size);
}

void Document::set_bounds(int accessor) {
    if (!model_->accessors[static_cast<std::size_t>(accessor)].is_bounded) return;
    const std::span<const float> values = data<float>(accessor);
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    model_->bounds.push_back({accessor, {{*least}, {*most}}});
}

void Document::set_bounds(int accessor, const Bounds& bounds) {
    if (!model_->accessors[static_cast<std::size_t>(accessor)].is_bounded) return;
    model_->bounds.push_back({accessor, bounds});
}

File Document::write(Container container) { return container == Container::kGlb ? write_glb() : write_gltf(); }

File Document::write_glb() {
    char* const start = model_->memory.data();
    JsonText json(start);
    write_json(*model_, json, {});
    const std::size_t data = model_->bytes, heads = data > 0 ? kGlbHeads : kGlbTextAt;
    const std::size_t text = aligned(json.bytes());
    if (heads + text > model_->first) throw std::length_error("more JSON than there is room for");
    const std::size_t first = model_->first - heads - text;
    char* const at = start + first + kGlbTextAt;
    std::memmove(at, start, json.bytes());
    std::fill(at + json.bytes(), at + text, ' ');
    write_glb_heads(start + first, text, data);
    return {std::move(model_->memory), first};
}

File Document::write_gltf() {
    std::size_t before = 0;  // bytes of JSON that stand before the buffer
    JsonText json;
    write_json(*model_, json, [&](const JsonText& so_far) { before = so_far.bytes(); });
    const std::size_t data = model_->bytes, encoded = base64_bytes(data);
    std::string& file = model_->memory;
    file.resize(json.bytes() + encoded + 1);
    char* const text = file.data() + before;
    std::memmove(text + (encoded - data), file.data(), data);
    write_base64(reinterpret_cast<const unsigned char*>(text + (encoded - data)), data, text);
    JsonText written(file.data());
    write_json(*model_, written, [&](JsonText& to) { to.skip(encoded); });
    file.back() = '\n';
    return {std::move(file)};
}

}  // namespace tuftwave::server::gltf
