#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gltf/document.hpp"
#include "gltf/json_text.hpp"

namespace tuftwave::server::gltf {

/// What a document is made of, as small as may be: a moving hairstyle has 65,536 joints, each with a node, an accessor,
/// a sampler and a channel.
struct Document::Model {
    /// How EXT_meshopt_compression keeps a view: elements of `stride` bytes as some bytes of the file's own buffer.
    struct Packed {
        enum class Mode { kAttributes, kTriangles };

        std::size_t offset, bytes, stride, count;
        Mode mode;
    };
    struct View {
        Purpose purpose;
        std::size_t offset, bytes, stride;
        std::optional<Packed> packed = std::nullopt;  ///< then it is a view of the fallback buffer
    };
    struct Bounded {
        int accessor;
        Bounds box;  ///< of single numbers the first of each corner
    };
    /// Where in `texts` one of them stands.
    struct Text {
        std::size_t first = 0, bytes = 0;
    };
    struct Placed {
        std::optional<int> parent;  ///< that comes before it
        Text members;               ///< but for children and extras, as in the file: numbers are made text once
        Text extras = {};
    };
    struct Material {
        std::string name;
        std::array<double, 3> color;
    };
    struct Mesh {
        std::string name;
        Primitive primitive;
        int node = -1;  ///< that shows it
        std::optional<int> skin = std::nullopt;
    };
    struct Skin {
        std::vector<int> joints;
        int matrices, root;
    };
    struct Animation {
        std::string name;
        int times;
        Interpolation interpolation;
        std::vector<Channel> channels;
        std::string extras;
    };

    std::string generator, extras;
    std::vector<View> views;
    std::vector<Accessor> accessors;
    std::vector<Bounded> bounds;  ///< in no order
    std::vector<Placed> nodes;
    std::string texts;  ///< of nodes, in no order
    std::vector<int> roots;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Skin> skins;
    std::vector<Animation> animations;
    std::string memory;        ///< of the whole file
    std::size_t first = 0;     ///< where in it the buffer begins
    std::size_t bytes = 0;     ///< of the buffer
    std::size_t fallback = 0;  ///< bytes of the buffer that packed views are views of, which is in no file
    std::vector<std::string_view> extensions;  ///< that whoever reads the file must know, in alphabetical order

    std::string_view text(const Text& text) const { return std::string_view(texts).substr(text.first, text.bytes); }
    Text add_text(std::string_view text);
    Text add_members(const Node& node);
};

/// Bytes of a number.
std::size_t size_of(Document::Component component);

/// Numbers in an element of an accessor.
std::size_t width_of(Document::Shape shape);

/// Bytes of a model's JSON at most, bounds that are still to come included: a sum over what it is made of, since to
/// write it only to count takes as long as to write it.
std::size_t most_json_bytes(const Document::Model& model);

/// Bytes that something takes with the room behind it, so that what follows begins at a multiple of 4.
constexpr std::size_t aligned(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

constexpr std::size_t kGlbTextAt = 12 + 8;         ///< where a GLB's JSON begins
constexpr std::size_t kGlbHeads = kGlbTextAt + 8;  ///< bytes of a GLB that are neither JSON nor its buffer

/// Writes what stands before a GLB's JSON and between that and its buffer.
/// @param text  bytes of JSON with the blanks behind it, a multiple of 4
/// @param data  bytes of the buffer; there is no head for none
/// @return      where the buffer begins
char* write_glb_heads(char* file, std::size_t text, std::size_t data);

/// Writes a model's JSON with its keys in alphabetical order.
/// @param uri   called where the content of the buffer's uri would stand; empty leaves the uri out
void write_json(const Document::Model& model, JsonText& to, const std::function<void(JsonText&)>& uri);

}  // namespace tuftwave::server::gltf
