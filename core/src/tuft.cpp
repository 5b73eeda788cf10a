// Based on: Shimosoyama, Yamamoto, Noma. NPR Hair Modeling by Controlling the Shape of Tufts. Section 3.
// Differs: besides circles there are flattened, rolled and twisted sections.
#include "tuftwave/tuft.hpp"

#include "rings.hpp"
#include "tuftwave/vector_checks.hpp"
#include "unfold.hpp"

namespace tuftwave {
namespace {

Check check_stroke(const Tuft& tuft, const Head& head, const Limits& limits) {
    if (Check wrong = check_count(tuft.points.size(), 2, limits.points_per_tuft, "/points")) return wrong;
    if (Check wrong = check_positions(tuft.points, limits, "/points")) return wrong;
    if (length(tuft.points.front() - head.center) < kShortestDirection)
        return Error{ErrorCode::kDegenerate,
                     "/points/0",
                     length(tuft.points.front() - head.center),
                     "a root at least 1e-9 metres from head.center",
                     {},
                     {}};
    double drawn = 0;
    for (std::size_t i = 1; i < tuft.points.size(); ++i) drawn += length(tuft.points[i] - tuft.points[i - 1]);
    if (drawn < kShortestDirection)
        return Error{ErrorCode::kDegenerate, "/points", drawn, "a stroke at least 1e-9 metres long", {}, {}};
    return {};
}

bool has_flat_tip(const Tuft& tuft) { return tuft.widest_at >= 100; }

}  // namespace

Check check_tuft(const Tuft& tuft, const Head& head, const Limits& limits) {
    if (Check wrong = check_stroke(tuft, head, limits)) return wrong;
    if (Check wrong = check_range(tuft.diameter, limits.diameter, "/diameter")) return wrong;
    if (Check wrong = check_range(tuft.widest_at, limits.widest_at, "/widest_at")) return wrong;
    if (Check wrong = check_range(tuft.flatness, limits.flatness, "/flatness")) return wrong;
    if (tuft.section == Section::kCircle && tuft.flatness != 0)
        return Error{ErrorCode::kConflict, "/flatness", tuft.flatness, "0 for a circle; set section to ellipse", 0, 0};
    if (Check wrong = check_range(tuft.twist_deg, limits.twist_deg, "/twist_deg")) return wrong;
    if (Check wrong = check_range(tuft.roll_deg, limits.roll_deg, "/roll_deg")) return wrong;
    if (Check wrong = check_range(tuft.joints, limits.joints_per_tuft, "/joints")) return wrong;
    if (Check wrong = check_range(tuft.phase, limits.phase, "/phase")) return wrong;
    return tuft.cycles ? check_range(*tuft.cycles, limits.cycles, "/cycles") : Check{};
}

Check check_detail(const MeshDetail& detail, const Limits& limits) {
    if (Check wrong = check_range(detail.tolerance, limits.tolerance, "/tolerance")) return wrong;
    if (Check wrong = check_range(detail.sides, limits.sides, "/sides")) return wrong;
    return detail.rings ? check_range(*detail.rings, limits.rings, "/rings") : Check{};
}

MeshPlan plan_mesh_size(const Tuft& tuft, const MeshDetail& detail) {
    MeshPlan mesh;
    mesh.ring_count = static_cast<std::size_t>(detail.rings.value_or(0));
    mesh.flat_tip = has_flat_tip(tuft);
    mesh.sides = detail.sides;
    return mesh;
}

Result<PlannedTuft> plan_tuft(const Tuft& tuft, const Head& head, const MeshDetail& detail, const Limits& limits,
                              Vectors vectors) {
    if (Check wrong = check_tuft(tuft, head, limits)) return *wrong;
    return plan_sound_tuft(tuft, head, detail, limits, vectors);
}

Result<PlannedTuft> plan_sound_tuft(const Tuft& tuft, const Head& head, const MeshDetail& detail, const Limits& limits,
                                    Vectors vectors) {
    std::vector<Vec3> points;
    points.reserve(tuft.points.size() + 1);
    points.push_back(sunk_root(head, tuft.points.front()));
    points.insert(points.end(), tuft.points.begin(), tuft.points.end());
    Curve curve(points, vectors);
    curve.face_away_from(head.center);

    Result<Rings> rings =
        choose_rings(curve, tuft, head.diameter_at_100 * tuft.diameter / 100, detail, limits, vectors);
    if (!rings) return rings.error();

    const CurveFrame &root = curve.first(), &tip = curve.last();
    PlannedTuft planned;
    MeshPlan& mesh = planned.mesh;
    mesh.root = root.point;
    mesh.tip = tip.point;
    mesh.root_direction = -root.tangent;
    mesh.tip_direction = tip.tangent;
    mesh.rings = std::move(rings).value();
    mesh.ring_count = mesh.rings.size();
    mesh.reach = unfolding_reach(mesh.rings, detail.sides, vectors);
    mesh.flat_tip = has_flat_tip(tuft);
    mesh.sides = detail.sides;
    mesh.joints = detail.skin ? tuft.joints : 0;
    if (detail.skin) planned.chain = chain_along(curve, tuft.joints);
    planned.chain.name = tuft.name;
    planned.chain.phase = tuft.phase;
    planned.chain.cycles = tuft.cycles;
    planned.chain.outward = normalized(tuft.points.front() - head.center);
    return planned;
}

}  // namespace tuftwave
