// What a GLB costs besides its vertices.
#include <cstring>
#include <vector>

#include "gltf/document.hpp"
#include "measure.hpp"
#include "work.hpp"

namespace tuftwave::bench {
namespace {

using server::gltf::Container;
using server::gltf::Document;

constexpr int kPrimitiveCalls = 20;

/// A GLB of vertices that are there already. @param vertices  three floats each
server::gltf::File pack(const std::vector<float>& vertices) {
    Document document("bench");
    const std::size_t bytes = vertices.size() * sizeof(float);
    const int view = document.add_view(Document::Purpose::kAttribute, bytes, 12);
    const int accessor =
        document.add_accessor({view, 0, vertices.size() / 3, Document::Component::kF32, Document::Shape::kVec3});
    document.allocate(Container::kGlb);
    std::memcpy(document.bytes(accessor).data(), vertices.data(), bytes);
    return document.write(Container::kGlb);
}

/// Many of the smallest tubes, each a primitive, beside all of them in one: call by call, since the difference is
/// small.
void measure_primitives(const Workloads& workloads) {
    Hairstyle tubes = hair_of(workloads, workloads.strokes.size());
    tubes.mesh.rings = 2;
    tubes.mesh.sides = 3;
    server::gltf::Look split = merged_look();
    split.layout = server::gltf::Layout::kPerTuft;
    std::vector<double> ms;
    for (int call = 0; call < kPrimitiveCalls; ++call) {
        const double merged = time_of([&] { sent(hair_glb(tubes, merged_look(), InOrder())); });
        ms.push_back(time_of([&] { sent(hair_glb(tubes, split, InOrder())); }) - merged);
    }
    print_samples("primitives/tuftwave", ms);
}

/// As many vertices as W1's GLB without a skin has bytes for.
std::vector<float> w1_of_floats() { return std::vector<float>(45'000'000 / 12 * 3, 0.5F); }

}  // namespace

void measure_pack_memory(const Workloads&) {
    const std::vector<float> vertices = w1_of_floats();
    const double before = peak_bytes();
    const auto bytes = static_cast<double>(pack(vertices).bytes().size());
    print_value("pack_memory/tuftwave", (peak_bytes() - before) / bytes, "GLBs");
}

void measure_packing(const Workloads& workloads) {
    const std::vector<float> vertices = w1_of_floats();
    measure("pack/tuftwave", [&] { sent(pack(vertices)); });
    measure("pack/fresh_copy", [&] {
        const std::vector<float> copy(vertices);
        keep(copy.data());
    });
    measure_primitives(workloads);
}

}  // namespace tuftwave::bench
