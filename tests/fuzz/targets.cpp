#include "targets.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "api/routes.hpp"

namespace tuftwave::server::fuzz {
namespace {

std::string name_of(const std::string_view path) {
    std::string name(path.substr(path.rfind("/v1/", 0) == 0 ? 4 : 1));
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
}

}  // namespace

std::vector<Target> targets() {
    std::vector<Target> all;
    for (const Route& route : routes()) {
        if (route.method == "POST")
            all.push_back({name_of(route.path), run_operation, std::string(route.path), route.takes_file});
    }
    all.push_back({"glb", run_glb, "", true});
    all.push_back({"json", run_json});
    all.push_back({"poses", run_poses});
    all.push_back({"query", run_query});
    all.push_back({"request", run_request});
    all.push_back({"sheets", run_sheets});
    return all;
}

const Target* find_target(const std::string_view name) {
    static const std::vector<Target> all = targets();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Target& target) { return target.name == name; });
    return found == all.end() ? nullptr : &*found;
}

void require(const bool holds, const std::string_view what) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %.*s\n", static_cast<int>(what.size()), what.data());
    std::abort();
}

}  // namespace tuftwave::server::fuzz
