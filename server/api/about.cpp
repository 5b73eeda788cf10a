#include "api/about.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "api/json_guard.hpp"
#include "api/reader.hpp"
#include "api/schedules.hpp"
#include "assets/assets.hpp"
#include "character/file_limits.hpp"
#include "version.hpp"

namespace tuftwave::server {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(Range range) { return {{"minimum", range.minimum}, {"maximum", range.maximum}}; }

Json counts_json(const Limits& limits) {
    return {{"tufts", limits.tufts},
            {"points_per_tuft", limits.points_per_tuft},
            {"points", limits.points},
            {"fills", limits.fills},
            {"scalp_vertices", limits.scalp_vertices},
            {"scalp_triangles", limits.scalp_triangles},
            {"chains", limits.chains},
            {"nodes_per_chain", limits.nodes_per_chain},
            {"joints", limits.joints},
            {"node_poses", limits.node_poses},
            {"joint_keys", limits.joint_keys},
            {"drawn_nodes", limits.drawn_nodes},
            {"rings_per_tuft", limits.rings_per_tuft},
            {"vertices", limits.vertices},
            {"triangles", limits.triangles},
            {"frames", limits.frames},
            {"sheet_frames", limits.sheet_frames},
            {"sheet_cells", limits.sheet_cells},
            {"pictures", limits.pictures}};
}

Json ranges_json(const Limits& limits) {
    return {{"coordinate", to_json(limits.coordinate)},
            {"root_depth", to_json(limits.root_depth)},
            {"diameter_at_100", to_json(limits.diameter_at_100)},
            {"scalp_radius", to_json(limits.scalp_radius)},
            {"scalp_vertex", to_json(limits.scalp_vertex)},
            {"diameter", to_json(limits.diameter)},
            {"widest_at", to_json(limits.widest_at)},
            {"flatness", to_json(limits.flatness)},
            {"twist_deg", to_json(limits.twist_deg)},
            {"roll_deg", to_json(limits.roll_deg)},
            {"joints", to_json(limits.joints_per_tuft)},
            {"origin", to_json(limits.origin)},
            {"density", to_json(limits.density)},
            {"tufts_per_meter", to_json(limits.tufts_per_meter)},
            {"min_gap", to_json(limits.min_gap)},
            {"sides", to_json(limits.sides)},
            {"rings", to_json(limits.rings)},
            {"tolerance", to_json(limits.tolerance)},
            {"amplitude", to_json(limits.amplitude)},
            {"spatial_period", to_json(limits.spatial_period)},
            {"lightness", to_json(limits.lightness)},
            {"tip_exponent", to_json(limits.tip_exponent)},
            {"period", to_json(limits.period)},
            {"fps", to_json(limits.fps)},
            {"hold", to_json(limits.hold)},
            {"lift", to_json(limits.lift)},
            {"phase", to_json(limits.phase)},
            {"cycles", to_json(limits.cycles)},
            {"gust_wavelength", to_json(limits.gust_wavelength)},
            {"spread", to_json(limits.spread)},
            {"seed", to_json(kSeedRange)},
            {"repeat", to_json(limits.repeat)},
            {"fit_steps", to_json(limits.fit_steps)},
            {"rest_length", to_json(limits.rest_length)}};
}

Json files_json() {
    const character::FileLimits& limits = character::kFileLimits;
    return {{"bytes", limits.bytes},
            {"json_bytes", limits.json_bytes},
            {"json_depth", limits.json_depth},
            {"json_values", limits.json_values},
            {"keys_per_object", limits.keys_per_object},
            {"nodes", limits.nodes},
            {"joints", limits.joints},
            {"name_bytes", limits.name_bytes},
            {"json_memory", limits.json_memory}};
}

constexpr std::string_view kSwaggerPage = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Tuftwave API</title>
<link rel="icon" href="/docs/favicon-32x32.png">
<link rel="stylesheet" href="/docs/swagger-ui.css">
<body style="margin:0">
<div id="ui"></div>
<script src="/docs/swagger-ui-bundle.js"></script>
<script src="/docs/start.js"></script>
</body>
</html>
)";

constexpr std::string_view kStartScript =
    "SwaggerUIBundle({ url: '/openapi.yaml', dom_id: '#ui', deepLinking: true, validatorUrl: null });\n";

/// Served where the server was built without swagger-ui-dist.
constexpr std::string_view kPlainPage = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Tuftwave API</title>
<body style="font:1rem/1.5 sans-serif;max-width:48rem;margin:3rem auto;padding:0 1rem">
<h1>Tuftwave API</h1>
<p>The contract is <a href="/openapi.yaml">/openapi.yaml</a> (OpenAPI 3.1).</p>
<p>This server was built without npm, so the page to read and try it is not included: install npm and run script/server again.</p>
</body>
</html>
)";

/// @param body  lives as long as the program
Response page(std::string_view type, std::string_view body) {
    return {200, std::string(type), "", {{"Cache-Control", "no-cache"}}, body};
}

struct File {
    std::string_view name, type;
};
constexpr std::array<File, 3> kFiles{{{"swagger-ui.css", "text/css; charset=utf-8"},
                                      {"swagger-ui-bundle.js", "text/javascript; charset=utf-8"},
                                      {"favicon-32x32.png", "image/png"}}};

}  // namespace

Answer get_limits(const Request&, const Context& context) {
    const JsonLimits json_limits;
    const Json json{{"body_bytes", json_limits.bytes},
                    {"json_depth", json_limits.depth},
                    {"json_values", json_limits.values},
                    {"json_memory", json_limits.memory},
                    {"files", files_json()},
                    {"counts", counts_json(context.limits)},
                    {"ranges", ranges_json(context.limits)}};
    return Response{200, "application/json", json.dump(), {}};
}

Answer get_version(const Request&, const Context&) {
    static const std::string text = Json{{"name", "tuftwave"}, {"version", kVersion}, {"api", "v1"}}.dump();
    return Response{200, "application/json", "", {}, text};
}

Answer get_openapi(const Request&, const Context&) {
    return page("application/yaml; charset=utf-8", asset("openapi.yaml").value_or(""));
}

Answer get_docs(const Request&, const Context&) {
    return page("text/html; charset=utf-8", asset("swagger-ui-bundle.js") ? kSwaggerPage : kPlainPage);
}

Answer get_docs_file(const Request& request, const Context&) {
    const std::string_view name = std::string_view(request.path).substr(std::string_view("/docs/").size());
    if (name == "start.js") return page("text/javascript; charset=utf-8", kStartScript);
    for (const File& file : kFiles) {
        if (file.name != name) continue;
        if (const auto content = asset(name)) return page(file.type, *content);
    }
    return Problem{ProblemCode::kNotFound, "", {}, {}};
}

}  // namespace tuftwave::server
