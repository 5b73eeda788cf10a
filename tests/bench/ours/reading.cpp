// How long the service takes to read W1's request: from text to a checked hairstyle.
#include <stdexcept>
#include <variant>

#include "api/hair.hpp"
#include "measure.hpp"
#include "work.hpp"

namespace tuftwave::bench {

void measure_reading(const Workloads& workloads) {
    const server::Request request{
        "POST", "/v1/tufts", {}, {{"content-type", "application/json"}}, workloads.strokes_text};
    // A request is read in full before its points are counted; with too many of them nothing else is done.
    Limits limits;
    limits.points = 1;
    const InOrder in_order;
    const server::Context context{limits, in_order, {}};
    const auto answer = server::post_tufts(request, context);
    const auto* problem = std::get_if<server::Problem>(&answer);
    if (problem == nullptr || problem->fields.size() != 1 || problem->fields.front().pointer != "/tufts")
        throw std::runtime_error("the request was not read as far as its points");
    measure("read/tuftwave", [&] { keep(server::post_tufts(request, context)); });
}

}  // namespace tuftwave::bench
