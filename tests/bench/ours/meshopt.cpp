// What it costs to mesh W1 and pack it, and how much shorter it gets.
#include <thread>
#include <utility>

#include "exec/pool.hpp"
#include "measure.hpp"
#include "work.hpp"

namespace tuftwave::bench {

void measure_meshopt(const Workloads& workloads) {
    using server::gltf::Compression;
    const Hairstyle hairstyle = hair_of(workloads, workloads.strokes.size());
    const auto bytes_of = [&](Compression compression, const ForEach& for_each) {
        server::gltf::File file = hair_glb(hairstyle, merged_look(), for_each, compression);
        const auto bytes = static_cast<double>(file.bytes().size());
        sent(std::move(file));
        return bytes;
    };
    const double plain = bytes_of(Compression::kNone, InOrder());
    print_value("meshopt_size/tuftwave", 100 * bytes_of(Compression::kMeshopt, InOrder()) / plain, "%");
    measure("meshopt/tuftwave", [&] { bytes_of(Compression::kMeshopt, InOrder()); });
    if (std::thread::hardware_concurrency() < 2) return;
    server::Pool helper(1, 1);  // whoever calls takes part, so that two work
    measure("meshopt_two/tuftwave", [&] { bytes_of(Compression::kMeshopt, helper.for_each()); });
}

}  // namespace tuftwave::bench
