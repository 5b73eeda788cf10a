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

void measure_glb(const char* name, const Hairstyle& hairstyle, const ForEach& for_each) {
    measure(name, [&] { sent(hair_glb(hairstyle, merged_look(), for_each)); });
}

/// By two workers, where there are two cores.
void measure_glb_of_two(const char* name, const Hairstyle& hairstyle) {
    if (std::thread::hardware_concurrency() < 2) return;
    server::Pool helper(1, 1);  // whoever calls takes part, so that two work
    measure_glb(name, hairstyle, helper.for_each());
}

}  // namespace

void measure_first(const Workloads& workloads) {
    const Hairstyle hairstyle = hair_of(workloads, workloads.strokes.size());
    std::size_t bytes = 0;
    print_samples("w1_first/tuftwave",
                  {time_of([&] { bytes = hair_glb(hairstyle, merged_look(), InOrder()).bytes().size(); })});
    measure_glb("w1_first/warm", hairstyle, InOrder());
    measure_memory("w1_first", bytes);
}

void measure_many(const Workloads& workloads) {
    const Hairstyle hairstyle = hair_of(workloads, kMany);
    const double before = peak_bytes();
    const std::size_t bytes = hair_glb(hairstyle, merged_look(), InOrder()).bytes().size();
    print_value("many_bytes/tuftwave", static_cast<double>(bytes), "B");
    print_value("many_peak/tuftwave", peak_bytes() - before, "B");
    measure_glb("many_fresh/tuftwave", hairstyle, InOrder());
    server::memory::keep_at_most(2 * bytes);  // as a service with 4 GiB for answers
    measure_glb("many_one/tuftwave", hairstyle, InOrder());
    measure_glb_of_two("many/tuftwave", hairstyle);
    measure_memory("many", bytes);
}

void measure_hair(const Workloads& workloads) {
    const Hairstyle thousand = hair_of(workloads, workloads.strokes.size()), one = hair_of(workloads, 1);
    measure_glb("w1/tuftwave", thousand, InOrder());
    measure_glb_of_two("w1_two/tuftwave", thousand);
    measure_glb("one/tuftwave", one, InOrder());
    const std::size_t bytes = hair_glb(thousand, merged_look(), InOrder()).bytes().size();
    print_value("w1_bytes/tuftwave", static_cast<double>(bytes), "B");
    measure_memory("w1", bytes);
}

}  // namespace tuftwave::bench
