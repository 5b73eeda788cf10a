// A dense ring with rows to crown and neck: 10,000 tufts, without meshing.
#include <stdexcept>

#include "measure.hpp"
#include "tuftwave/fill.hpp"
#include "work.hpp"

namespace tuftwave::bench {

void measure_fill(const Workloads&) {
    const Head head;
    const Limits limits;
    Tuft drawn;
    drawn.points = {{0, 0.08, 0.06}, {0, 0.08, 0.09}, {0, 0.05, 0.11}, {0, -0.05, 0.11}};
    FillSettings settings;
    settings.density = {100.0, 100.0, 100.0};
    settings.tufts_per_meter = 1120;
    settings.jitter_seed = 1;
    const auto fill = [&] {
        const auto plan = plan_fill(drawn, nullptr, settings, head, limits);
        if (!plan) throw std::runtime_error(plan.error().allowed);
        return make_fill(*plan, head, nullptr, limits, InOrder(), {});
    };
    measure("fill/tuftwave", [&] { keep(fill()); });
    print_value("fill_tufts/tuftwave", static_cast<double>(fill()->tufts.size()), "tufts");
}

}  // namespace tuftwave::bench
