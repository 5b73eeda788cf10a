// W1 and one tuft, warm; its first call; and 20,000 strokes.
#include <sys/mman.h>
#include <sys/resource.h>

#include <cstring>
#include <stdexcept>
#include <thread>

#include "exec/pool.hpp"
#include "measure.hpp"
#include "work.hpp"

namespace tuftwave::bench {
namespace {

constexpr std::size_t kMany = 20'000;

/// Bytes that a process has held at most.
double peak() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// The time to write so many bytes where nobody has written before, as the first answer must.
double fresh_write(std::size_t bytes) {
    void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::runtime_error("no memory");
    const double ms = time_of([&] {
        std::memset(memory, 1, bytes);
        keep(memory);
    });
    munmap(memory, bytes);
    return ms;
}

}  // namespace

void measure_first(const Workloads& workloads) {
    const Hairstyle hairstyle = hair_of(workloads, workloads.strokes.size());
    std::size_t bytes = 0;
    print_samples("ours.w1.first",
                  {time_of([&] { bytes = hair_glb(hairstyle, merged_look(), InOrder()).size(); })});
    print_samples("ours.w1.fresh_write", {fresh_write(bytes), fresh_write(bytes), fresh_write(bytes)});
    measure("ours.w1.warm_again", [&] { keep(hair_glb(hairstyle, merged_look(), InOrder())); });
}

void measure_many(const Workloads& workloads) {
    const Hairstyle hairstyle = hair_of(workloads, kMany);
    const double before = peak();
    const std::size_t bytes = hair_glb(hairstyle, merged_look(), InOrder()).size();
    print_value("ours.many.bytes", static_cast<double>(bytes), "B");
    print_value("ours.many.peak", peak() - before, "B");
    measure("ours.many", [&] { keep(hair_glb(hairstyle, merged_look(), InOrder())); });
    std::string memory(bytes, ' ');
    measure("ours.many.memset", [&] {
        std::memset(memory.data(), 1, memory.size());
        keep(memory);
    });
}

void measure_hair(const Workloads& workloads) {
    const Hairstyle thousand = hair_of(workloads, workloads.strokes.size()), one = hair_of(workloads, 1);
    const server::gltf::Look merged = merged_look();
    measure("ours.w1", [&] { keep(hair_glb(thousand, merged, InOrder())); });
    if (std::thread::hardware_concurrency() > 1) {
        server::Pool helper(1, 1);  // whoever calls takes part, so that two work
        measure("ours.w1.two", [&] { keep(hair_glb(thousand, merged, helper.for_each())); });
    }
    measure("ours.one", [&] { keep(hair_glb(one, merged, InOrder())); });
    const std::string file = hair_glb(thousand, merged, InOrder());
    print_value("ours.w1.bytes", static_cast<double>(file.size()), "B");
    print_value("ours.w1.skinned", file.find("JOINTS_0") == std::string::npos ? 0 : 1, "");
}

}  // namespace tuftwave::bench
