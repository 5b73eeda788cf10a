#include "api/routes.hpp"
#include "fuzz_limits.hpp"
#include "http/target.hpp"
#include "sound_answer.hpp"
#include "targets.hpp"

namespace tuftwave::server::fuzz {

/// The first line is the query, all the rest the body.
void run_operation(const Target& target, const std::string_view input) {
    static const Limits limits = small_limits();
    const auto found = find_route("POST", target.path);
    const Route& route = *std::get<const Route*>(found);
    const std::size_t end = input.find('\n');
    Request request{"POST", target.path, {}, {}, {}};
    if (const auto asked = parse_target("/?" + std::string(input.substr(0, end)))) request.query = asked->query;
    if (end != std::string_view::npos) request.body = input.substr(end + 1);
    request.headers = {{"content-type", route.takes_file ? "model/gltf-binary" : "application/json"}};
    const std::string fault = fault_of(route.run(request, {limits, InOrder(), {}}));
    require(fault.empty(), fault);
}

}  // namespace tuftwave::server::fuzz
