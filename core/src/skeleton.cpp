// Based on: our own choice of bones of equal arc length; the papers take the skeleton as given.
#include "tuftwave/skeleton.hpp"

#include <algorithm>

#include "tuftwave/vector_checks.hpp"

namespace tuftwave {
namespace {

Check check_rotation(const Quat& q, const Limits& limits) {
    const double parts[] = {q.x, q.y, q.z, q.w};
    for (int i = 0; i < 4; ++i) {
        if (!is_within(parts[i], limits.coordinate))
            return check_range(parts[i], limits.coordinate, "/" + std::to_string(i));
    }
    if (dot(q, q) < kShortestDirection * kShortestDirection)
        return Error{ErrorCode::kDegenerate, "", std::sqrt(dot(q, q)), "a quaternion with a length above 1e-9", {}, {}};
    return {};
}

Check check_nodes(const Chain& chain, const Limits& limits) {
    if (Check wrong = check_count(chain.nodes.size(), 2, limits.nodes_per_chain, "/nodes")) return wrong;
    if (Check wrong = check_positions(chain.nodes, limits, "/nodes")) return wrong;
    double whole = 0;
    for (std::size_t i = 1; i < chain.nodes.size(); ++i) whole += length(chain.nodes[i] - chain.nodes[i - 1]);
    if (whole < kShortestDirection)
        return Error{
            ErrorCode::kDegenerate, "/nodes", whole, "nodes that are at least 1e-9 metres apart in all", {}, {}};
    return {};
}

double smooth_step(double part) { return part * part * (3 - 2 * part); }

}  // namespace

Check check_chain(const Chain& chain, const Limits& limits) {
    if (Check wrong = check_nodes(chain, limits)) return wrong;
    if (chain.rest_rotations.size() != chain.nodes.size()) {
        const auto count = static_cast<double>(chain.nodes.size());
        return Error{ErrorCode::kConflict,
                     "/rest_rotations",
                     static_cast<double>(chain.rest_rotations.size()),
                     "one rotation per node: " + std::to_string(chain.nodes.size()),
                     count,
                     count};
    }
    for (std::size_t i = 0; i < chain.rest_rotations.size(); ++i) {
        if (Check wrong = check_rotation(chain.rest_rotations[i], limits))
            return within("/rest_rotations/" + std::to_string(i), *std::move(wrong));
    }
    if (Check wrong = check_rotation(chain.parent_rotation, limits)) return within("/parent_rotation", *wrong);
    if (chain.outward) {
        if (Check wrong = check_direction(*chain.outward, limits, "/outward")) return wrong;
    }
    if (Check wrong = check_range(chain.phase, limits.phase, "/phase")) return wrong;
    return chain.cycles ? check_range(*chain.cycles, limits.cycles, "/cycles") : Check{};
}

Check check_chains(std::span<const Chain> chains, const Limits& limits) {
    if (Check wrong = check_count(chains.size(), 1, limits.chains, "")) return wrong;
    std::size_t bones = 0;
    for (std::size_t i = 0; i < chains.size(); ++i) {
        if (Check wrong = check_chain(chains[i], limits)) return within("/" + std::to_string(i), *wrong);
        bones += chains[i].nodes.size() - 1;
    }
    return check_total(bones, limits.joints, "bones in all chains", "");
}

Chain chain_along(const Curve& curve, int joints) {
    const double bone = curve.arc_length() / joints;
    const auto bones = static_cast<std::size_t>(joints);
    std::vector<double> along;  // nodes and, between them, the middles of the bones
    along.reserve(2 * bones + 1);
    for (int i = 0; i < joints; ++i) along.insert(along.end(), {i * bone, (i + 0.5) * bone});
    along.push_back(joints * bone);
    std::vector<CurveFrame> frames(along.size());
    curve.at(along, frames);

    Chain chain;
    chain.nodes.reserve(bones + 1);
    chain.rest_rotations.reserve(bones + 1);
    for (std::size_t i = 0; i <= bones; ++i) chain.nodes.push_back(frames[2 * i].point);
    Quat parent;
    for (std::size_t i = 0; i < bones; ++i) {
        const CurveFrame& middle = frames[2 * i + 1];
        const Vec3 chord = chain.nodes[i + 1] - chain.nodes[i];
        const Vec3 y_axis = length(chord) > 1e-6 * bone ? normalized(chord) : middle.tangent;
        const Vec3 upright = rejected(middle.normal, y_axis);
        const Vec3 z_axis = length(upright) > kSmallestSine ? normalized(upright) : any_perpendicular(y_axis);
        const Quat global = rotation_from_axes(cross(y_axis, z_axis), y_axis, z_axis);
        chain.rest_rotations.push_back(normalized(inverse(parent) * global));
        parent = global;
    }
    chain.rest_rotations.emplace_back();  // the tip turns nothing
    return chain;
}

Influence influence_at(double along, int joints) {
    const double from_first_middle = std::clamp(along, 0.0, 1.0) * joints - 0.5;
    const auto last = static_cast<std::uint16_t>(joints - 1);
    if (from_first_middle <= 0) return {0, 0, 0};
    if (from_first_middle >= last) return {last, last, 0};
    const auto first = static_cast<std::uint16_t>(from_first_middle);
    return {first, static_cast<std::uint16_t>(first + 1), smooth_step(from_first_middle - first)};
}

}  // namespace tuftwave
