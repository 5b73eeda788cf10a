// The plain C++ version of W1, of one tuft, and of W2.
//
//   tuftwave_bench_afternoon FOLDER      with w1.json and w2.json; prints lines as tests/bench/bench.py reads them
#include <cstdio>

#include "hair.hpp"
#include "measure.hpp"
#include "workloads.hpp"

namespace {

using namespace tuftwave::bench;

std::vector<afternoon::Points> points_of(const std::vector<Line>& lines) {
    std::vector<afternoon::Points> all;
    for (const Line& line : lines) {
        all.emplace_back();
        for (const Point& point : line) all.back().emplace_back(point[0], point[1], point[2]);
    }
    return all;
}

std::string tubes(const std::vector<afternoon::Points>& strokes) {
    afternoon::Mesh mesh;
    for (const afternoon::Points& stroke : strokes) afternoon::add_tube(mesh, stroke);
    return afternoon::mesh_file(mesh);
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return std::fputs("usage: tuftwave_bench_afternoon FOLDER\n", stderr), 2;
    const Workloads workloads = read_workloads(arguments[1]);
    const auto strokes = points_of(workloads.strokes), chains = points_of(workloads.chains);
    measure("w1/afternoon", [&] { keep(tubes(strokes)); });
    measure("one/afternoon", [&] { keep(tubes({strokes.front()})); });
    measure("w2/afternoon", [&] { keep(afternoon::clip_file(chains, afternoon::move(chains, 12), 2, 24)); });
    measure("evaluation/afternoon", [&] { keep(afternoon::move(chains, 12)); });
    print_value("w1_bytes/afternoon", static_cast<double>(tubes(strokes).size()), "B");
    print_value("w2_bytes/afternoon",
                static_cast<double>(afternoon::clip_file(chains, afternoon::move(chains, 12), 2, 24).size()), "B");
}
