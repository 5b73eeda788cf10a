// What it costs to pack W1 beside meshing it, and how much shorter it gets.
#include "measure.hpp"
#include "memory/buffers.hpp"
#include "work.hpp"

namespace tuftwave::bench {

void measure_meshopt(const Workloads& workloads) {
    using server::gltf::Compression;
    const Hairstyle hairstyle = hair_of(workloads, workloads.strokes.size());
    const auto bytes_of = [&](Compression compression) {
        server::gltf::File file = hair_glb(hairstyle, merged_look(), InOrder(), compression);
        const auto bytes = static_cast<double>(file.bytes().size());
        sent(std::move(file));
        return bytes;
    };
    const double plain = bytes_of(Compression::kNone);
    print_value("meshopt_size/tuftwave", 100 * bytes_of(Compression::kMeshopt) / plain, "%");
    measure("meshopt/tuftwave", [&] { bytes_of(Compression::kMeshopt); });
}

}  // namespace tuftwave::bench
