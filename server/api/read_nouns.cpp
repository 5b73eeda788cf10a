#include "api/read_nouns.hpp"

#include "api/choices.hpp"

namespace tuftwave::server {
namespace {

constexpr std::size_t kLongestFillName = 48;  // characters; leaves room for an underscore and a number

void read_wave(const JsonValue value, const Place& place, FieldProblems& problems, Wave& into) {
    Fields fields(value, place, problems);
    fields.number("amplitude", into.amplitude);
    fields.number("spatial_period", into.spatial_period);
    fields.number("lightness", into.lightness);
    fields.number("tip_exponent", into.tip_exponent);
    fields.done();
}

void read_phasing(const JsonValue value, const Place& place, FieldProblems& problems, const Limits& limits,
                  Phasing& into) {
    Fields fields(value, place, problems);
    fields.choice("step", kPhaseSteps, into.step);
    fields.number("gust_wavelength", into.gust_wavelength);
    fields.number("spread", into.spread);
    fields.seed("seed", into.seed);
    fields.integer("cycles", limits.cycles, into.cycles);
    fields.done();
}

ScalpEllipsoid read_scalp_ellipsoid(const JsonValue value, const Place& place, FieldProblems& problems) {
    ScalpEllipsoid ellipsoid;
    Fields fields(value, place, problems);
    fields.require("radii");
    fields.vector("center", ellipsoid.center);
    fields.vector("radii", ellipsoid.radii);
    fields.done();
    return ellipsoid;
}

ScalpMesh read_scalp_mesh(const JsonValue value, const Place& place, FieldProblems& problems, const Limits& limits) {
    ScalpMesh mesh;
    Fields fields(value, place, problems);
    fields.require("positions");
    fields.require("triangles");
    fields.flat_vectors("positions", limits.scalp_vertices, mesh.positions);
    fields.flat_triples("triangles", limits.scalp_triangles, limits.scalp_vertex, mesh.triangles);
    fields.done();
    return mesh;
}

void read_scalp(const JsonValue value, const Place& place, FieldProblems& problems, const Limits& limits,
                ScalpShape& into) {
    Fields fields(value, place, problems);
    int shapes = 0;
    fields.optional_member("ellipsoid", [&](const JsonValue ellipsoid, const Place& at) {
        into = read_scalp_ellipsoid(ellipsoid, at, problems);
        ++shapes;
    });
    fields.optional_member("mesh", [&](const JsonValue mesh, const Place& at) {
        into = read_scalp_mesh(mesh, at, problems, limits);
        ++shapes;
    });
    fields.done();
    if (value.is_object() && shapes != 1)
        problems.add({shapes == 0 ? ProblemCode::kMissingField : ProblemCode::kConflict,
                      place.pointer(),
                      {},
                      "either ellipsoid or mesh",
                      {},
                      {}});
}

Origin read_origin(const JsonValue value, const Place& place, FieldProblems& problems, const Limits& limits) {
    Origin origin;
    Fields fields(value, place, problems);
    fields.require("kind");
    fields.require("index");
    fields.choice("kind", kFillKinds, origin.kind);
    fields.integer("index", limits.origin, origin.index);
    fields.integer("parent", limits.origin, origin.parent);
    fields.done();
    return origin;
}

void read_densities(const JsonValue value, const Place& place, FieldProblems& problems, Densities& into) {
    Fields fields(value, place, problems);
    fields.number("along", into.along);
    fields.number("crown", into.crown);
    fields.number("neck", into.neck);
    fields.done();
}

}  // namespace

void read_head(const JsonValue value, const Place& place, FieldProblems& problems, const Limits& limits, Head& into) {
    Fields fields(value, place, problems);
    fields.vector("center", into.center);
    fields.vector("up", into.up);
    fields.vector("front", into.front);
    fields.number("root_depth", into.root_depth);
    fields.number("diameter_at_100", into.diameter_at_100);
    fields.optional_member(
        "scalp", [&](const JsonValue scalp, const Place& at) { read_scalp(scalp, at, problems, limits, into.scalp); });
    fields.done();
}

void read_tuft(const JsonValue value, const Place& place, FieldProblems& problems, const Limits& limits, Tuft& into) {
    Fields fields(value, place, problems);
    fields.require("points");
    fields.text("name", kLongestName, into.name);
    fields.vectors("points", limits.points_per_tuft, into.points);
    fields.number("diameter", into.diameter);
    fields.number("widest_at", into.widest_at);
    fields.choice("taper", kTapers, into.taper);
    fields.choice("section", kSections, into.section);
    fields.number("flatness", into.flatness);
    fields.number("twist_deg", into.twist_deg);
    fields.number("roll_deg", into.roll_deg);
    fields.integer("joints", limits.joints_per_tuft, into.joints);
    fields.number("phase", into.phase);
    fields.integer("cycles", limits.cycles, into.cycles);
    fields.optional_member("origin", [&](const JsonValue origin, const Place& at) {
        into.origin = read_origin(origin, at, problems, limits);
    });
    fields.done();
}

void read_chain(const JsonValue value, const Place& place, FieldProblems& problems, const Limits& limits, Chain& into) {
    Fields fields(value, place, problems);
    fields.require("nodes");
    fields.text("name", kLongestName, into.name);
    fields.vectors("nodes", limits.nodes_per_chain, into.nodes);
    fields.text("block", kLongestName, into.block);
    into.rest_rotations.clear();
    fields.rotations("rest_rotations", limits.nodes_per_chain, into.rest_rotations);
    fields.rotation("parent_rotation", into.parent_rotation);
    fields.vector("outward", into.outward);
    fields.number("phase", into.phase);
    fields.integer("cycles", limits.cycles, into.cycles);
    fields.done();
    const auto given = value.find("rest_rotations");
    if (!given || given->is_null()) into.rest_rotations.assign(into.nodes.size(), Quat{});
}

void read_timing(const JsonValue value, const Place& place, FieldProblems& problems, const Limits& limits,
                 Timing& into) {
    Fields fields(value, place, problems);
    fields.number("period", into.period);
    fields.frame_rate("fps", into.fps);
    fields.integer("hold", limits.hold, into.hold);
    fields.choice("short_holds", kShortHolds, into.short_holds);
    fields.choice("sampling", kSamplings, into.sampling);
    fields.done();
}

void read_motion(const JsonValue value, const Place& place, FieldProblems& problems, const Limits& limits,
                 Motion& into) {
    Fields fields(value, place, problems);
    fields.member("wave", [&](const JsonValue wave, const Place& at) { read_wave(wave, at, problems, into.wave); });
    fields.member("timing", [&](const JsonValue timing, const Place& at) {
        read_timing(timing, at, problems, limits, into.timing);
    });
    fields.choice("mode", kModes, into.mode);
    fields.vector("wind", into.wind);
    std::optional<Vec3> up(into.up);
    fields.vector("up", up);
    into.up = up.value_or(into.up);
    fields.choice("droop", kDroops, into.droop);
    fields.boolean("one_sided", into.one_sided);
    fields.number("lift", into.lift);
    fields.member("phase", [&](const JsonValue phase, const Place& at) {
        read_phasing(phase, at, problems, limits, into.phase);
    });
    fields.done();
}

void read_mesh(const JsonValue value, const Place& place, FieldProblems& problems, const Limits& limits,
               MeshDetail& detail, gltf::Look& look) {
    Fields fields(value, place, problems);
    fields.number("tolerance", detail.tolerance);
    fields.integer("rings", limits.rings, detail.rings);
    fields.integer("sides", limits.sides, detail.sides);
    fields.boolean("skin", detail.skin);
    fields.choice("layout", kLayouts, look.layout);
    fields.color("color", look.color);
    fields.done();
}

void read_formulas(Fields& fields, Formulas& into) { fields.choice("formulas", kFormulas, into); }

void read_fill_settings(Fields& fields, FieldProblems& problems, FillSettings& into) {
    std::optional<std::string> name;
    fields.text("name", kLongestFillName, name);
    into.name = name.value_or(into.name);
    fields.number("tufts_per_meter", into.tufts_per_meter);
    fields.member("density",
                  [&](const JsonValue value, const Place& at) { read_densities(value, at, problems, into.density); });
    fields.optional_member("jitter", [&](const JsonValue value, const Place& at) {
        Fields jitter(value, at, problems);
        jitter.seed("seed", into.jitter_seed.emplace());
        jitter.done();
    });
    fields.choice("spacing", kSpacings, into.spacing);
    fields.choice("arc", kArcs, into.arc);
    fields.choice("direction", kFillDirections, into.direction);
    fields.boolean("resample", into.resample);
    fields.number("min_gap", into.min_gap);
}

}  // namespace tuftwave::server
