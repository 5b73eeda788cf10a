#include "gltf/packed_file.hpp"

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>

#include "gltf/meshopt.hpp"
#include "gltf/model.hpp"
#include "gltf/quantized.hpp"
#include "memory/buffers.hpp"

namespace tuftwave::server::gltf {
namespace {

using Component = Document::Component;
using Model = Document::Model;
using Mode = Model::Packed::Mode;
using Views = std::vector<std::span<const std::byte>>;

/// What a view is a row of.
struct Elements {
    std::size_t stride = 0;
    Component component{};
    std::size_t vertices = 0;  ///< that indices count
};

std::size_t place(int index) { return static_cast<std::size_t>(index); }

/// Gives each list of indices a view of its own, since a packed view is nothing but triangles of one kind.
void split_indices(Model& model, Views& contents) {
    const Views shared = contents;
    std::vector<bool> is_alone(model.accessors.size()), is_taken(model.views.size());
    for (const Model::Mesh& mesh : model.meshes) {
        const std::size_t index = place(mesh.primitive.indices);
        Document::Accessor& indices = model.accessors[index];
        if (is_alone[index]) continue;
        is_alone[index] = true;
        const std::size_t bytes = indices.count * size_of(indices.component);
        const std::span<const std::byte> content = shared[place(indices.view)].subspan(indices.offset, bytes);
        if (is_taken[place(indices.view)]) {
            indices.view = static_cast<int>(model.views.size());
            model.views.push_back({Document::Purpose::kIndex, 0, 0, 0});
            contents.emplace_back();
        } else {
            is_taken[place(indices.view)] = true;
        }
        indices.offset = 0;
        model.views[place(indices.view)].bytes = bytes;
        contents[place(indices.view)] = content;
    }
}

std::vector<Elements> elements_of(const Model& model) {
    std::vector<Elements> all(model.views.size());
    for (const Document::Accessor& accessor : model.accessors) {
        Elements& elements = all[place(accessor.view)];
        const std::size_t stride = model.views[place(accessor.view)].stride;
        elements.stride = stride > 0 ? stride : size_of(accessor.component) * width_of(accessor.shape);
        elements.component = accessor.component;
    }
    for (const Model::Mesh& mesh : model.meshes) {
        const Document::Accessor& indices = model.accessors[place(mesh.primitive.indices)];
        all[place(indices.view)].vertices = model.accessors[place(mesh.primitive.positions)].count;
    }
    return all;
}

template <class Index>
std::span<const Index> as_indices(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const Index*>(bytes.data()), bytes.size() / sizeof(Index)};
}

/// Room for a view, packed or as it is; more than the latter, so that it is laid out like a packed one.
std::size_t most_for(std::size_t bytes, const Elements& elements) {
    const std::size_t count = bytes / elements.stride;
    const std::size_t packed = elements.vertices > 0 ? most_for_triangles(count, elements.vertices)
                                                     : most_for_attributes(count, elements.stride);
    return std::max(bytes + 1, packed);
}

std::size_t encode_indices(std::span<const std::byte> bytes, const Elements& elements, std::span<char> to) {
    if (elements.component == Component::kU32) return encode_triangles(as_indices<std::uint32_t>(bytes), to);
    const auto narrow = as_indices<std::uint16_t>(bytes);
    return encode_triangles(std::vector<std::uint32_t>(narrow.begin(), narrow.end()), to);
}

/// @return  bytes that it took; as many as there were if it would be no fewer, and then they are the same
std::size_t encode(std::span<const std::byte> bytes, const Elements& elements, std::span<char> to) {
    const std::size_t length =
        elements.vertices > 0 ? encode_indices(bytes, elements, to) : encode_attributes(bytes, elements.stride, to);
    if (length < bytes.size()) return length;
    std::ranges::copy(bytes, std::as_writable_bytes(to).begin());
    return bytes.size();
}

/// Says where each view is. @param lengths  bytes in the file; as many as the view has if it is not packed
void lay_out(Model& model, const std::vector<Elements>& elements, const std::vector<std::size_t>& lengths) {
    model.bytes = model.fallback = 0;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        Model::View& view = model.views[i];
        const bool is_packed = lengths[i] != view.bytes;
        view.packed.reset();
        view.offset = is_packed ? model.fallback : model.bytes;
        if (is_packed) {
            const std::size_t stride = elements[i].stride;
            const Mode mode = elements[i].vertices > 0 ? Mode::kTriangles : Mode::kAttributes;
            view.packed = Model::Packed{model.bytes, lengths[i], stride, view.bytes / stride, mode};
            model.fallback += aligned(view.bytes);
        }
        model.bytes += aligned(lengths[i]);
    }
    model.extensions = {"KHR_mesh_quantization"};
    if (model.fallback > 0) model.extensions = {"EXT_meshopt_compression", "KHR_mesh_quantization"};
}

std::size_t json_bytes(const Model& model) {
    JsonText json;
    write_json(model, json, {});
    return json.bytes();
}

/// Puts views together that were written with room behind each, at the end of all of that: so memory that is used again
/// is never too short.
/// @param starts  of the views, in `room`
void close_up(const Model& model, const std::vector<std::size_t>& starts, std::span<char> room) {
    char* const data = room.data() + room.size() - model.bytes;
    for (std::size_t i = model.views.size(); i-- > 0;) {
        const Model::View& view = model.views[i];
        const std::size_t length = view.packed ? view.packed->bytes : view.bytes;
        char* const to = data + (view.packed ? view.packed->offset : view.offset);
        std::memmove(to, room.data() + starts[i], length);
        std::fill(to + length, to + aligned(length), '\0');
    }
}

/// Writes what stands before the views, which are at the end. @param memory  with room for it
File with_heads(const Model& model, std::string memory) {
    const std::size_t text = aligned(json_bytes(model)), first = memory.size() - model.bytes - kGlbHeads - text;
    char* const start = memory.data() + first;
    JsonText json(start + kGlbTextAt);
    write_json(model, json, {});
    std::fill(start + kGlbTextAt + json.bytes(), start + kGlbTextAt + text, ' ');
    write_glb_heads(start, text, model.bytes);
    return {std::move(memory), first};
}

}  // namespace

File packed_file(Document& document, const ForEach& for_each, const std::stop_token& stop) {
    Model& model = document.model();
    Quantized quantized = quantize(model, for_each, stop);
    Views& contents = quantized.views;
    split_indices(model, contents);
    const std::vector<Elements> elements = elements_of(model);
    std::vector<std::size_t> rooms, starts{0};
    for (std::size_t i = 0; i < contents.size(); ++i) {
        rooms.push_back(aligned(most_for(contents[i].size(), elements[i])));
        starts.push_back(starts.back() + rooms.back());
    }
    lay_out(model, elements, rooms);  // no number will have more digits
    const std::size_t data = aligned(kGlbHeads + json_bytes(model)), size = data + starts.back();
    std::string memory = memory::take_buffer(size, size);
    const std::span<char> views = std::span(memory).subspan(data);
    std::vector<std::size_t> lengths(contents.size());
    for_each(contents.size(), [&](std::size_t i) {
        if (!stop.stop_requested()) lengths[i] = encode(contents[i], elements[i], views.subspan(starts[i], rooms[i]));
    });
    lay_out(model, elements, lengths);
    close_up(model, starts, views);
    memory::give_back(std::move(model.memory));
    memory::give_back(std::move(quantized.memory));
    return with_heads(model, std::move(memory));
}

}  // namespace tuftwave::server::gltf
