// What tests/bench/bench.py compares with the peers.
//
//   tuftwave_bench_ours FOLDER WHAT...      FOLDER with w1.json and w2.json; WHAT as below, each in the order given
#include <cstdio>
#include <exception>
#include <map>
#include <string>

#include "memory/heap.hpp"
#include "work.hpp"

int main(int count, char** arguments) {
    using namespace tuftwave::bench;
    const std::map<std::string, void (*)(const Workloads&)> all{
        {"first", measure_first}, {"many", measure_many},       {"pack_memory", measure_pack_memory},
        {"hair", measure_hair},   {"motion", measure_motion},   {"reading", measure_reading},
        {"fill", measure_fill},   {"packing", measure_packing}, {"meshopt", measure_meshopt},
    };
    if (count < 3) return std::fputs("usage: tuftwave_bench_ours FOLDER WHAT...\n", stderr), 2;
    tuftwave::server::memory::set_up_heap();  // as the service does
    try {
        const Workloads workloads = read_workloads(arguments[1]);
        for (int i = 2; i < count; ++i) all.at(arguments[i])(workloads);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "tuftwave_bench_ours: %s\n", error.what());
        return 1;
    }
}
