#include "tuftwave/hairstyle.hpp"

#include <algorithm>
#include <functional>
#include <string>

#include "hair_fills.hpp"

namespace tuftwave {
namespace {

/// Tufts planned before their rings are counted: enough for any number of threads; at 4,096 rings of 96 bytes and 64
/// corners of 4 bytes each they take 110 MB at most.
constexpr std::size_t kTuftsAtOnce = 64;

/// The same where no more than sizes are planned, which takes a fifth of a microsecond each: to hand over so few as
/// above would take longer.
constexpr std::size_t kSizesAtOnce = 1'024;

const Error kCancelled{ErrorCode::kCancelled, "", {}, "", {}, {}};

/// What is wrong with a tuft at the place that the request has for it: its own, or that of the fill it comes from.
/// @param tuft  counted over the drawn and the filled ones
Error at_tuft(const Hairstyle& hairstyle, const HairPlan& plan, std::size_t tuft, Error error) {
    std::size_t next = hairstyle.tufts.size();
    if (tuft < next) return within("/tufts/" + std::to_string(tuft), std::move(error));
    std::size_t fill = 0;
    while (fill + 1 < plan.fills.size() && tuft >= (next += plan.fills[fill].tuft_count())) ++fill;
    error.field = "/fills/" + std::to_string(fill);
    return error;
}

/// All tufts of a hairstyle, the drawn ones first.
using Tufts = std::vector<const Tuft*>;

Check check_counts(const Tufts& tufts, const MeshDetail& mesh, const Limits& limits) {
    if (Check wrong = check_count(tufts.size(), 1, limits.tufts, "/tufts")) return wrong;
    std::size_t points = 0, joints = 0;
    for (const Tuft* tuft : tufts) {
        points += tuft->points.size();
        joints += static_cast<std::size_t>(tuft->joints > 0 ? tuft->joints : 0);
    }
    if (Check wrong = check_total(points, limits.points, "points in all tufts", "/tufts")) return wrong;
    return mesh.skin ? check_total(joints, limits.joints, "joints in all tufts", "/tufts") : Check{};
}

Check check_mesh_size(std::size_t vertices, std::size_t triangles, const Limits& limits) {
    Check wrong = check_total(vertices, limits.vertices, "vertices", "/mesh");
    if (!wrong) wrong = check_total(triangles, limits.triangles, "triangles", "/mesh");
    if (wrong) wrong->allowed += "; use a larger tolerance, fewer rings or fewer sides";
    return wrong;
}

/// Where the rings are given, how large the mesh will be is known before any work.
Check check_given_rings(std::size_t tufts, const MeshDetail& mesh, const Limits& limits) {
    if (!mesh.rings) return {};
    const auto rings = static_cast<std::size_t>(*mesh.rings);
    const auto sides = static_cast<std::size_t>(mesh.sides);
    const std::size_t vertices = tufts * (2 + rings * (sides + 1));
    const std::size_t triangles = tufts * 2 * sides * rings;
    return check_mesh_size(vertices, triangles, limits);
}

/// Adds the tufts in [from, to) to the plan's counts.
Check count_mesh(HairPlan& plan, std::size_t from, std::size_t to, const Limits& limits) {
    for (std::size_t i = from; i < to; ++i) {
        plan.vertices += plan.tufts[i].vertex_count();
        plan.indices += plan.tufts[i].index_count();
        plan.joints += static_cast<std::size_t>(plan.tufts[i].joints);
    }
    return check_mesh_size(plan.vertices, plan.indices / 3, limits);
}

bool keeps_sizes_only(const MeshDetail& mesh) { return mesh.rings && !mesh.skin; }

/// Plans one tuft, or no more than the size of its mesh.
Check plan_one_tuft(const Tuft& tuft, const Hairstyle& hairstyle, const Limits& limits, MeshPlan& mesh, Chain& chain) {
    if (keeps_sizes_only(hairstyle.mesh)) {
        if (Check wrong = check_tuft(tuft, hairstyle.head, limits)) return wrong;
        mesh = plan_mesh_size(tuft, hairstyle.mesh);
        chain.name = tuft.name;
        return {};
    }
    Result<PlannedTuft> planned = plan_tuft(tuft, hairstyle.head, hairstyle.mesh, limits);
    if (!planned) return planned.error();
    mesh = std::move(planned->mesh);
    chain = std::move(planned->chain);
    return {};
}

/// Plans the tufts in [from, to); of several that are wrong the first is named.
Check plan_some_tufts(const Hairstyle& hairstyle, const Tufts& tufts, std::size_t from, std::size_t to,
                      const Limits& limits, const ForEach& for_each, const std::stop_token& stop, HairPlan& plan) {
    std::vector<Check> wrong(to - from);
    const auto plan_one = [&](std::size_t job) {
        if (stop.stop_requested()) return;
        const std::size_t i = from + job;
        if (Check found = plan_one_tuft(*tufts[i], hairstyle, limits, plan.tufts[i], plan.chains[i]))
            wrong[job] = at_tuft(hairstyle, plan, i, *std::move(found));
    };
    for_each(to - from, std::cref(plan_one));  // which needs no memory of its own
    if (stop.stop_requested()) return kCancelled;
    for (Check& error : wrong) {
        if (error) return std::move(error);
    }
    return {};
}

/// Plans every tuft and counts what the mesh will be. Some at a time: rings take memory, and too many of them must be
/// noticed before all have been made; always the same ones, so that the same tuft is named whoever does the work.
Check plan_tufts(const Hairstyle& hairstyle, const Tufts& tufts, const Limits& limits, const ForEach& for_each,
                 const std::stop_token& stop, HairPlan& plan) {
    const std::size_t count = tufts.size();
    plan.tufts.resize(count);
    plan.chains.resize(count);
    const std::size_t at_once = keeps_sizes_only(hairstyle.mesh) ? kSizesAtOnce : kTuftsAtOnce;
    for (std::size_t from = 0; from < count; from += at_once) {
        const std::size_t to = std::min(from + at_once, count);
        if (Check wrong = plan_some_tufts(hairstyle, tufts, from, to, limits, for_each, stop, plan)) return wrong;
        if (Check wrong = count_mesh(plan, from, to, limits)) return wrong;
    }
    return {};
}

/// @param error  of move_chains, whose chains are the plan's tufts
Error at_chain(const Hairstyle& hairstyle, const HairPlan& plan, Error error) {
    const std::string chains = "/chains/";
    if (error.field == "/chains") error.field = "/tufts";
    if (!error.field.starts_with(chains)) return error;
    const std::size_t end = std::min(error.field.find('/', chains.size()), error.field.size());
    const std::size_t tuft = std::stoul(error.field.substr(chains.size(), end - chains.size()));
    error.field.erase(0, end);
    return at_tuft(hairstyle, plan, tuft, std::move(error));
}

Result<HairMotion> plan_motion(const Hairstyle& hairstyle, const Limits& limits, const ForEach& for_each,
                               const std::stop_token& stop, const HairPlan& plan, Schedule schedule) {
    auto moved = move_chains(plan.chains, *hairstyle.motion, schedule, limits, for_each, stop);
    if (!moved) return at_chain(hairstyle, plan, moved.error());
    return HairMotion{std::move(schedule), std::move(moved).value()};
}

const Tuft& tuft_at(const HairPlan& plan, std::size_t tuft) {
    const std::vector<Tuft>* tufts = &plan.hairstyle->tufts;
    for (auto fill = plan.filled.begin(); tuft >= tufts->size(); ++fill) {
        tuft -= tufts->size();
        tufts = &*fill;
    }
    return (*tufts)[tuft];
}

}  // namespace

const MeshPlan& mesh_plan(const HairPlan& plan, std::size_t tuft, MeshPlan& made) {
    const MeshPlan& kept = plan.tufts[tuft];
    if (!kept.rings.empty()) return kept;
    const Hairstyle& hairstyle = *plan.hairstyle;
    made = std::move(plan_sound_tuft(tuft_at(plan, tuft), hairstyle.head, hairstyle.mesh, plan.limits)->mesh);
    return made;
}

Result<HairPlan> plan_hairstyle(const Hairstyle& hairstyle, const Limits& limits, const ForEach& for_each,
                                std::stop_token stop) {
    Tufts tufts;
    tufts.reserve(hairstyle.tufts.size());
    for (const Tuft& tuft : hairstyle.tufts) tufts.push_back(&tuft);
    if (Check wrong = check_counts(tufts, hairstyle.mesh, limits)) return *wrong;
    if (Check wrong = check_head(hairstyle.head, limits)) return within("/head", *wrong);
    if (Check wrong = check_detail(hairstyle.mesh, limits)) return within("/mesh", *wrong);
    if (Check wrong = check_given_rings(tufts.size(), hairstyle.mesh, limits)) return *wrong;
    if (hairstyle.motion && !hairstyle.mesh.skin)
        return Error{ErrorCode::kConflict, "/mesh/skin", "false", "true, since the hair moves", {}, {}};
    std::optional<Schedule> schedule;
    if (hairstyle.motion) {
        Result<Schedule> made = make_schedule(hairstyle.motion->timing, hairstyle.formulas, limits);
        if (!made) return within("/motion/timing", made.error());
        schedule = std::move(made).value();
        if (Check wrong = check_motion(*hairstyle.motion, *schedule, limits)) return within("/motion", *wrong);
    }
    Result<std::vector<Filled>> fills = fill_hairstyle(hairstyle, limits, for_each, stop);
    if (!fills) return fills.error();

    HairPlan plan;
    plan.hairstyle = &hairstyle;
    plan.limits = limits;
    for (Filled& fill : *fills) {
        plan.fills.push_back(fill.report);
        for (const Tuft& tuft : plan.filled.emplace_back(std::move(fill.tufts))) tufts.push_back(&tuft);
    }
    if (Check wrong = check_counts(tufts, hairstyle.mesh, limits)) return *wrong;
    if (Check wrong = check_given_rings(tufts.size(), hairstyle.mesh, limits)) return *wrong;
    if (Check wrong = plan_tufts(hairstyle, tufts, limits, for_each, stop, plan)) return *wrong;
    if (schedule) {
        Result<HairMotion> moved = plan_motion(hairstyle, limits, for_each, stop, plan, std::move(*schedule));
        if (!moved) return moved.error();
        plan.motion = std::move(moved).value();
    }
    return plan;
}

}  // namespace tuftwave
