#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <initializer_list>
#include <string>
#include <variant>
#include <vector>

#include "character/character.hpp"
#include "character/found_chains.hpp"
#include "character/glb.hpp"
#include "character/own_vertices.hpp"

/// Small characters, grown by calls.
namespace tuftwave::server::character {

inline constexpr int kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123, kUnsignedInt = 5125,
                     kFloat = 5126;

template <class T>
std::string bytes_of(const std::vector<T>& numbers) {
    std::string bytes(numbers.size() * sizeof(T), '\0');
    if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

/// A glTF file; every call adds something and gives back its index.
struct Sample {
    FileJson json = FileJson::parse(R"({"asset": {"version": "2.0"}, "nodes": []})");
    std::string binary;

    FileJson& node(int index) { return json["nodes"][static_cast<std::size_t>(index)]; }

    int add_node(const std::string& name, int parent = -1, const Vec3& at = {0, -0.1, 0}) {
        const int index = static_cast<int>(json["nodes"].size());
        json["nodes"].push_back({{"name", name}, {"translation", {at.x, at.y, at.z}}});
        if (parent >= 0) node(parent)["children"].push_back(index);
        return index;
    }

    /// Nodes one below the other.
    std::vector<int> add_line(std::initializer_list<const char*> names, int parent = -1) {
        std::vector<int> line;
        for (const char* const name : names) line.push_back(parent = add_node(name, parent));
        return line;
    }

    std::size_t add(const char* list, FileJson item) {
        json[list].push_back(std::move(item));
        return json[list].size() - 1;
    }

    std::size_t add_skin(const std::vector<int>& joints) { return add("skins", {{"joints", joints}}); }

    std::size_t add_accessor(const std::string& bytes, int component, const char* type, std::size_t count) {
        while (binary.size() % 4 != 0) binary += '\0';
        const std::size_t view =
            add("bufferViews", {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
        binary += bytes;
        return add("accessors", {{"bufferView", view}, {"componentType", component}, {"type", type}, {"count", count}});
    }

    /// Vertices that follow one joint alone. @param points  relative to the joint, since there is no bind matrix
    std::size_t add_vertices(std::size_t skin, unsigned char slot, const std::vector<Vec3>& points) {
        std::vector<float> places, weights;
        std::vector<unsigned char> slots;
        for (const Vec3& point : points) {
            for (const double part : {point.x, point.y, point.z}) places.push_back(static_cast<float>(part));
            weights.insert(weights.end(), {1, 0, 0, 0});
            slots.insert(slots.end(), {slot, 0, 0, 0});
        }
        const FileJson attributes{{"POSITION", add_accessor(bytes_of(places), kFloat, "VEC3", points.size())},
                                  {"JOINTS_0", add_accessor(bytes_of(slots), kUnsignedByte, "VEC4", points.size())},
                                  {"WEIGHTS_0", add_accessor(bytes_of(weights), kFloat, "VEC4", points.size())}};
        const std::size_t mesh =
            add("meshes", {{"primitives", FileJson::array({FileJson{{"attributes", attributes}}})}});
        const int carrier = add_node("mesh");
        node(carrier)["mesh"] = mesh;
        node(carrier)["skin"] = skin;
        return mesh;
    }

    /// A spring of VRM 1.0.
    void add_spring(const std::string& name, const std::vector<int>& joints) {
        FileJson list = FileJson::array();
        for (const int joint : joints) list.push_back({{"node", joint}});
        json["extensions"]["VRMC_springBone"]["springs"].push_back({{"name", name}, {"joints", list}});
    }

    /// A bone group of VRM 0.x.
    void add_group(const std::string& comment, const std::vector<int>& roots) {
        json["extensions"]["VRM"]["secondaryAnimation"]["boneGroups"].push_back(
            {{"comment", comment}, {"bones", roots}});
    }

    /// A bone of VRM 1.0's humanoid.
    void set_bone(const char* bone, int index) {
        json["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"][bone]["node"] = index;
    }
};

/// What is wrong with a file; a fault at "no fault" if nothing is.
inline Fault read_fault(const FileJson& json) {
    const auto read = read_character(json);
    if (const auto* fault = std::get_if<Fault>(&read)) return *fault;
    return {Fault::Kind::kMalformed, "no fault", {}, {}, {}, {}};
}

inline Character read(const Sample& sample) {
    const auto read = read_character(sample.json);
    if (const auto* character = std::get_if<Character>(&read)) return *character;
    ADD_FAILURE() << std::get<Fault>(read).pointer << ": " << std::get<Fault>(read).allowed;
    return {};
}

inline std::vector<OwnVertices> own_vertices(const Sample& sample, const Character& character) {
    const auto found = find_own_vertices(sample.json, sample.binary, character, 1'000);
    if (const auto* own = std::get_if<std::vector<OwnVertices>>(&found)) return *own;
    ADD_FAILURE() << std::get<Fault>(found).pointer << ": " << std::get<Fault>(found).allowed;
    return std::vector<OwnVertices>(character.nodes.size());
}

inline FoundChains chains_in(const Sample& sample, std::size_t most_nodes = 65) {
    const Character character = read(sample);
    return find_chains(character, own_vertices(sample, character), most_nodes);
}

/// The chain of that name; a failure and an empty one if there is none.
inline FoundChain chain_named(const FoundChains& found, const std::string& name) {
    for (const FoundChain& chain : found.chains) {
        if (chain.name == name) return chain;
    }
    ADD_FAILURE() << "no chain is called " << name;
    return {};
}

/// Why a node is in no chain, "" if nothing is said of it.
inline std::string reason_of(const FoundChains& found, int node) {
    for (const Skipped& skipped : found.skipped) {
        if (skipped.node == node) return std::string(skipped.reason);
    }
    return "";
}

}  // namespace tuftwave::server::character
