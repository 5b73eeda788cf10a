#include "hair_fills.hpp"

#include <string>

namespace tuftwave {
namespace {

/// A fill names its two tufts; what is wrong with one of them is wrong where it was drawn.
Error at_drawn_tuft(Error error, const HairFill& fill, const std::string& place) {
    const std::size_t tufts[] = {fill.from, fill.to.value_or(fill.from)};
    const std::string sides[] = {"/from/", "/to/"};
    for (std::size_t side = 0; side < 2; ++side) {
        if (!error.field.starts_with(sides[side])) continue;
        error.field.replace(0, sides[side].size() - 1, "/tufts/" + std::to_string(tufts[side]));
        return error;
    }
    return within(place, std::move(error));
}

Result<FillPlan> plan_one(const Hairstyle& hairstyle, std::size_t i, const Limits& limits) {
    const HairFill& fill = hairstyle.fills[i];
    const bool is_ring = !fill.to || *fill.to == fill.from;
    Result<FillPlan> plan = plan_fill(hairstyle.tufts[fill.from], is_ring ? nullptr : &hairstyle.tufts[*fill.to],
                                      fill.settings, hairstyle.head, limits);
    if (!plan) return at_drawn_tuft(plan.error(), fill, "/fills/" + std::to_string(i));
    return plan;
}

Result<std::vector<FillPlan>> plan_all(const Hairstyle& hairstyle, const Limits& limits, const std::stop_token& stop) {
    std::size_t tufts = hairstyle.tufts.size(), points = 0;
    for (const Tuft& tuft : hairstyle.tufts) points += tuft.points.size();
    std::vector<FillPlan> plans;
    for (std::size_t i = 0; i < hairstyle.fills.size(); ++i) {
        if (stop.stop_requested()) return Error{ErrorCode::kCancelled, "", {}, "", {}, {}};
        Result<FillPlan> plan = plan_one(hairstyle, i, limits);
        if (!plan) return plan.error();
        tufts += plan->tuft_count();
        points += plan->tuft_count() * plan->points_per_tuft();
        const std::string place = "/fills/" + std::to_string(i);
        if (Check wrong = check_total(tufts, limits.tufts, "tufts, drawn and filled", place)) return *wrong;
        if (Check wrong = check_total(points, limits.points, "points in all tufts, drawn and filled", place))
            return *wrong;
        plans.push_back(std::move(plan).value());
    }
    return plans;
}

}  // namespace

Result<std::vector<Filled>> fill_hairstyle(const Hairstyle& hairstyle, const Limits& limits, const ForEach& for_each,
                                           const std::stop_token& stop) {
    if (Check wrong = check_count(hairstyle.fills.size(), 0, limits.fills, "/fills")) return *wrong;
    if (hairstyle.fills.empty()) return std::vector<Filled>();
    const Result<std::vector<FillPlan>> plans = plan_all(hairstyle, limits, stop);
    if (!plans) return plans.error();
    const std::optional<Scalp> scalp = Scalp::of(hairstyle.head);

    std::vector<Filled> fills;
    for (const FillPlan& plan : *plans) {
        Result<Filled> filled = make_fill(plan, hairstyle.head, scalp ? &*scalp : nullptr, limits, for_each, stop);
        if (!filled) return at_drawn_tuft(filled.error(), hairstyle.fills[fills.size()], "");
        fills.push_back(std::move(filled).value());
    }
    return fills;
}

}  // namespace tuftwave
