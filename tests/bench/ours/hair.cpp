// W1 and one tuft, warm; the first call of a process; and 20,000 strokes.
#include <thread>
#include <utility>

#include "exec/pool.hpp"
#include "measure.hpp"
#include "memory.hpp"
#include "memory/buffers.hpp"
#include "work.hpp"

namespace tuftwave::bench {
namespace {

constexpr std::size_t kMany = 20'000;

}  // namespace

void measure_first(const Workloads& workloads) {
    const Hairstyle hairstyle = hair_of(workloads, workloads.strokes.size());
    std::size_t bytes = 0;
    print_samples("w1_first/tuftwave",
                  {time_of([&] { bytes = hair_glb(hairstyle, merged_look(), InOrder()).bytes().size(); })});
    measure("w1_first/warm", [&] { sent(hair_glb(hairstyle, merged_look(), InOrder())); });
    measure_memory("w1_first", bytes);
}

void measure_many(const Workloads& workloads) {
    const Hairstyle hairstyle = hair_of(workloads, kMany);
    const double before = peak_bytes();
    const std::size_t bytes = hair_glb(hairstyle, merged_look(), InOrder()).bytes().size();
    print_value("many_bytes/tuftwave", static_cast<double>(bytes), "B");
    print_value("many_peak/tuftwave", peak_bytes() - before, "B");
    const auto measure_with = [&](const char* name, const ForEach& for_each) {
        measure(name, [&] { sent(hair_glb(hairstyle, merged_look(), for_each)); });
    };
    measure_with("many_fresh/tuftwave", InOrder());
    server::memory::keep_at_most(2 * bytes);  // as a service with 4 GiB for answers
    measure_with("many_one/tuftwave", InOrder());
    if (std::thread::hardware_concurrency() > 1) {
        server::Pool helper(1, 1);
        measure_with("many/tuftwave", helper.for_each());
    }
    measure_memory("many", bytes);
}

void measure_hair(const Workloads& workloads) {
    const Hairstyle thousand = hair_of(workloads, workloads.strokes.size()), one = hair_of(workloads, 1);
    const server::gltf::Look merged = merged_look();
    measure("w1/tuftwave", [&] { sent(hair_glb(thousand, merged, InOrder())); });
    if (std::thread::hardware_concurrency() > 1) {
        server::Pool helper(1, 1);  // whoever calls takes part, so that two work
        measure("w1_two/tuftwave", [&] { sent(hair_glb(thousand, merged, helper.for_each())); });
    }
    measure("one/tuftwave", [&] { sent(hair_glb(one, merged, InOrder())); });
    const std::size_t bytes = hair_glb(thousand, merged, InOrder()).bytes().size();
    print_value("w1_bytes/tuftwave", static_cast<double>(bytes), "B");
    measure_memory("w1", bytes);
}

}  // namespace tuftwave::bench
