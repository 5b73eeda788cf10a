// How fast core is. Run by script/bench; nothing asserts a time.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tuftwave/elementary.hpp"
#include "tuftwave/fill.hpp"
#include "tuftwave/hairstyle.hpp"

namespace tuftwave {
namespace {

/// A head of `count` hanging tufts of eight points, all around and all different.
Hairstyle bob(int count) {
    Hairstyle hairstyle;
    for (int i = 0; i < count; ++i) {
        const auto around = elementary::sincos(2.399963 * i);  // the golden angle
        const double reach = 0.09 + 0.0001 * (i % 97);
        Tuft tuft;
        for (int k = 0; k < 8; ++k) {
            const double out = reach * (1 + 0.12 * k - 0.01 * k * k);
            tuft.points.push_back({out * around.sin, 0.1 - 0.03 * k, out * around.cos});
        }
        hairstyle.tufts.push_back(std::move(tuft));
    }
    hairstyle.motion.emplace();
    return hairstyle;
}

/// W1: 1,000 strokes of 8 points to tubes of 64 rings and 12 sides.
void plan_1000_tufts(benchmark::State& state) {
    Hairstyle hairstyle = bob(1000);
    hairstyle.motion.reset();
    hairstyle.mesh.rings = 64;
    for (auto _ : state) benchmark::DoNotOptimize(plan_hairstyle(hairstyle, {}, InOrder(), {}));
    state.SetItemsProcessed(state.iterations() * 1000);
}
BENCHMARK(plan_1000_tufts)->Unit(benchmark::kMillisecond);

void write_1000_tufts(benchmark::State& state) {
    Hairstyle hairstyle = bob(1000);
    hairstyle.motion.reset();
    hairstyle.mesh.rings = 64;
    const HairPlan plan = *plan_hairstyle(hairstyle, {}, InOrder(), {});
    for (auto _ : state) {
        for (const MeshPlan& tuft : plan.tufts) benchmark::DoNotOptimize(to_mesh(tuft));
    }
    state.counters["vertices/s"] =
        benchmark::Counter(static_cast<double>(plan.vertices), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(write_1000_tufts)->Unit(benchmark::kMillisecond);

/// W2: 200 chains of 16 nodes, 12 pictures.
void move_200_chains(benchmark::State& state) {
    Hairstyle hairstyle = bob(200);
    for (Tuft& tuft : hairstyle.tufts) tuft.joints = 15;
    hairstyle.motion->timing = {0.5, {24, 1}, 1, ShortHolds::kLast, Sampling::kUniform};
    const HairPlan plan = *plan_hairstyle(hairstyle, {}, InOrder(), {});
    for (auto _ : state) {
        benchmark::DoNotOptimize(move_chains(plan.chains, *hairstyle.motion, plan.motion->schedule, {}, InOrder(), {}));
    }
    state.counters["node-poses/s"] = benchmark::Counter(200.0 * 16 * 12, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(move_200_chains)->Unit(benchmark::kMillisecond);

/// A dense ring with rows to crown and neck, about 9,000 tufts. @param shape  of the scalp
void fill_a_ring(benchmark::State& state, const ScalpShape& shape) {
    Head head;
    head.scalp = shape;
    Tuft drawn;
    drawn.points = {{0, 0.08, 0.06}, {0, 0.08, 0.09}, {0, 0.05, 0.11}, {0, -0.05, 0.11}};
    FillSettings settings;
    settings.density = {100.0, 100.0, 100.0};
    settings.tufts_per_meter = 1000;
    settings.jitter_seed = 1;
    const Scalp* scalp = nullptr;
    const std::optional<Scalp> made = Scalp::of(head);
    if (made) scalp = &*made;
    std::size_t tufts = 0;
    for (auto _ : state) {
        const Filled filled =
            *make_fill(*plan_fill(drawn, nullptr, settings, head, {}), head, scalp, {}, InOrder(), {});
        tufts = filled.tufts.size();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(tufts));
}
BENCHMARK_CAPTURE(fill_a_ring, bare, ScalpShape())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fill_a_ring, on_an_ellipsoid, ScalpShape(ScalpEllipsoid{{}, {0.1, 0.1, 0.1}}))
    ->Unit(benchmark::kMillisecond);

void sincos(benchmark::State& state) {
    double x = 0;
    for (auto _ : state) benchmark::DoNotOptimize(elementary::sincos(x += 0.1));
}
BENCHMARK(sincos);

void pow(benchmark::State& state) {
    double x = 0;
    for (auto _ : state) benchmark::DoNotOptimize(elementary::pow(x += 1e-6, 1.7));
}
BENCHMARK(pow);

}  // namespace
}  // namespace tuftwave
