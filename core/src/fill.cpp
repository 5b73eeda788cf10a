// Based on: Shimosoyama, Yamamoto, Noma. NPR Hair Modeling by Controlling the Shape of Tufts. Section 4.
// Differs: on a ring the first tuft is copied to crown and neck once. With a scalp the roots are put on it and the
// strokes are kept out of it: bent, turned up or down less than their roots, and left out where nothing helps. What the
// paper's tufts do not have (taper, section, bones) lies between the two tufts, too.
#include "tuftwave/fill.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "crowding.hpp"
#include "tuftwave/clearance.hpp"
#include "tuftwave/vector_checks.hpp"

namespace tuftwave {
namespace {

std::vector<Vec3> in_head_frame(const Tuft& tuft, const HeadFrame& frame) {
    std::vector<Vec3> points;
    points.reserve(tuft.points.size());
    for (const Vec3& point : tuft.points) points.push_back(frame.to_head(point));
    return points;
}

/// Gives both strokes the larger number of points, or says why not.
Check equalize(FillPlan& plan) {
    auto& [from, to] = plan.strokes;
    if (from.size() == to.size()) return {};
    const bool is_printed = plan.settings.formulas == Formulas::kAsPrinted;
    if (!plan.settings.resample.value_or(!is_printed)) {
        const auto count = static_cast<double>(from.size());
        return Error{plan.settings.resample ? ErrorCode::kConflict : ErrorCode::kUndefinedAsPrinted,
                     "/to/points",
                     static_cast<double>(to.size()),
                     "as many points as from has, " + to_text(count) + "; or set resample to true",
                     count,
                     count};
    }
    const std::size_t count = std::max(from.size(), to.size());
    for (std::vector<Vec3>& stroke : plan.strokes) stroke = resampled(stroke, count);
    plan.is_resampled = {true, true};
    return {};
}

Tuft shape_of(const Tuft& tuft) {
    Tuft shape = tuft;
    shape.points.clear();
    return shape;
}

/// Directions of all parents: the first tuft, those along, the second one.
std::vector<Bearing> parent_roots(const FillPlan& plan) {
    const Gap& gap = plan.gap;
    std::vector<Bearing> roots{{gap.azimuth, gap.elevation}};
    for (const double share : plan.shares)
        roots.push_back({gap.azimuth + share * gap.sweep, gap.elevation + share * gap.rise});
    roots.push_back({gap.azimuth + gap.sweep, gap.elevation + gap.rise});
    return roots;
}

Check check_size(const FillPlan& plan, const Limits& limits) {
    if (Check wrong = check_total(plan.rows.count, limits.tufts, "tufts from one fill", "/density")) return wrong;
    return check_total(plan.rows.count * plan.points_per_tuft(), limits.points, "points in all tufts of a fill",
                       "/density");
}

/// A stroke that was drawn within the range of coordinates may be turned out of it.
Check check_reach(const Tuft& tuft, const Limits& limits) {
    for (const Vec3& point : tuft.points) {
        if (Check wrong = check_position(point, limits, "")) {
            wrong->field = "/from/points";
            wrong->allowed += " metres, also where the stroke is turned about the head";
            return wrong;
        }
    }
    return {};
}

/// A tuft's shape at the share `part` of the way from one tuft to another; what is no number comes from the nearer one.
Tuft shape_between(const Tuft& a, const Tuft& b, double part) {
    const auto mixed = [part](double from, double to) { return from + (to - from) * part; };
    Tuft tuft = part < 0.5 ? a : b;
    tuft.diameter = mixed(a.diameter, b.diameter);     // eq. (4)
    tuft.widest_at = mixed(a.widest_at, b.widest_at);  // eq. (4)
    tuft.section = a.section == b.section ? a.section : Section::kEllipse;
    tuft.flatness = mixed(a.flatness, b.flatness);
    tuft.twist_deg = mixed(a.twist_deg, b.twist_deg);
    tuft.roll_deg = mixed(a.roll_deg, b.roll_deg);
    tuft.joints = static_cast<int>(std::floor(mixed(a.joints, b.joints) + 0.5));
    tuft.phase = mixed(a.phase, b.phase);
    return tuft;
}

/// Shares of its turn up or down that a copy's stroke is tried with on a scalp. Hanging hair that is turned down as a
/// whole runs through the neck; the less it is turned, the more it hangs like its parent.
constexpr double kTilts[] = {1, 0.75, 0.5, 0.25, 0};

/// Makes the tufts of one plan.
class Filler {
  public:
    Filler(const FillPlan& plan, const Head& head, const Scalp* scalp)
        : plan_(plan),
          head_(head),
          scalp_(scalp),
          frame_(head),
          between_(plan.strokes[0], plan.strokes[1], plan.gap),
          bearings_(parent_roots(plan)) {
        if (scalp == nullptr) return;
        for (std::size_t side = 0; side < 2; ++side)
            clearances_[side] = clearance_of(plan.strokes[side], *scalp, head.root_depth);
        common_ = common_clearance(clearances_[0], clearances_[1]);
    }

    enum class Fate { kUntouched, kMovedOut, kInside, kOffScalp };

    struct Stroke {
        std::vector<Vec3> points;  // in the head's frame
        Fate fate = Fate::kUntouched;
    };

    Stroke stroke_of(const Placement& placement) const {
        if (scalp_ == nullptr) return {turned_stroke(placement, 1), Fate::kUntouched};
        for (const double tilt : kTilts) {
            Stroke stroke{turned_stroke(placement, tilt), Fate::kUntouched};
            put_on_scalp(stroke, wanted_clearance(placement.parent));
            if (stroke.fate == Fate::kInside) {
                if (placement.turn.elevation == 0) break;  // there is nothing to turn less
                continue;
            }
            if (tilt != 1 && stroke.fate == Fate::kUntouched) stroke.fate = Fate::kMovedOut;
            return stroke;
        }
        return {{}, Fate::kInside};
    }

    Tuft tuft_of(const Placement& placement, const std::vector<Vec3>& stroke) const {
        Tuft tuft = shape_between(plan_.tufts[0], plan_.tufts[1], part_of(placement.parent));
        for (const Vec3& point : stroke) tuft.points.push_back(frame_.to_model(point));
        tuft.origin = placement.origin;
        return tuft;
    }

    /// Metres that a copy's root must be away from others.
    double gap_of(const Placement& placement) const {
        const auto& [a, b] = plan_.tufts;
        const double diameter = a.diameter + (b.diameter - a.diameter) * part_of(placement.parent);
        return plan_.settings.min_gap * head_.diameter_at_100 * diameter / 100;
    }

  private:
    bool is_second(std::size_t parent) const { return parent + 1 == bearings_.size(); }

    /// l / (N + 1).
    double part_of(std::size_t parent) const {
        return static_cast<double>(parent) / static_cast<double>(bearings_.size() - 1);
    }

    std::vector<Vec3> parent_stroke(std::size_t parent) const {
        if (parent == 0) return plan_.strokes[0];
        if (is_second(parent)) return plan_.strokes[1];
        return between_.stroke(plan_.shares[parent - 1], part_of(parent));
    }

    const Clearance& wanted_clearance(std::size_t parent) const {
        if (parent == 0) return clearances_[0];
        return is_second(parent) ? clearances_[1] : common_;
    }

    /// The parent's stroke turned about the head's center.
    /// @param tilt  share of the turn up or down that the stroke goes through; the root goes all of it
    std::vector<Vec3> turned_stroke(const Placement& placement, double tilt) const {
        std::vector<Vec3> points = parent_stroke(placement.parent);
        const double azimuth = bearings_[placement.parent].azimuth;
        const Quat turn = turn_along_meridian(azimuth, placement.turn);
        const Vec3 root = points.front(), turned_root = rotated(turn, root);
        const Quat part = turn_along_meridian(azimuth, {placement.turn.azimuth, tilt * placement.turn.elevation});
        for (Vec3& point : points) point = tilt == 1 ? rotated(turn, point) : turned_root + rotated(part, point - root);
        return points;
    }

    void put_on_scalp(Stroke& stroke, const Clearance& wanted) const {
        const Vec3 root = stroke.points.front();
        const Vec3 direction = normalized(root);
        const std::optional<double> distance = scalp_->distance_towards(direction);
        if (!distance || *distance < kShortestDirection) {
            stroke.fate = Fate::kOffScalp;
            return;
        }
        const Vec3 move = *distance * direction - root;
        for (Vec3& point : stroke.points) point = point + move;
        switch (bend_outwards(stroke.points, wanted, *scalp_, head_.root_depth)) {
            case Bend::kNone:
                return;
            case Bend::kBent:
                stroke.fate = Fate::kMovedOut;
                return;
            case Bend::kStuck:
                stroke.fate = Fate::kInside;
                return;
        }
    }

    const FillPlan& plan_;
    const Head& head_;
    const Scalp* scalp_;
    HeadFrame frame_;
    StrokesBetween between_;
    std::vector<Bearing> bearings_;
    std::array<Clearance, 2> clearances_;
    Clearance common_;
};

/// Decides which tufts come, in their order, and counts.
class Chooser {
  public:
    Chooser(const FillPlan& plan, const Filler& filler, FillReport& report)
        : plan_(plan), filler_(filler), report_(report) {}

    bool is_chosen(const Placement& placement, const Filler::Stroke& stroke) {
        if (stroke.fate == Filler::Fate::kOffScalp) {
            ++report_.off_scalp;
            return false;
        }
        if (stroke.fate == Filler::Fate::kInside) {
            ++report_.inside;
            return false;
        }
        if (is_crowded(placement, stroke.points.front())) {
            ++report_.crowded;
            return false;
        }
        if (stroke.fate == Filler::Fate::kMovedOut) ++report_.moved_out;
        const FillKind kind = placement.origin.kind;
        ++(kind == FillKind::kAlong ? report_.along : kind == FillKind::kCrown ? report_.crown : report_.neck);
        return true;
    }

  private:
    /// Copies keep away from the two tufts, from those along, and from copies of their own kind.
    bool is_crowded(const Placement& placement, const Vec3& root) {
        if (plan_.settings.min_gap == 0) return false;
        if (placement.origin.kind == FillKind::kAlong) {
            along_.push_back(root);
            return false;
        }
        if (!accepted_ || placement.origin.kind != kind_) start(placement.origin.kind);
        if (accepted_->is_crowded(root, filler_.gap_of(placement))) return true;
        accepted_->add(root);
        return false;
    }

    void start(FillKind kind) {
        kind_ = kind;
        double largest = 0;
        for (const Placement& placement : plan_.rows.placements) largest = std::max(largest, filler_.gap_of(placement));
        accepted_.emplace(largest);
        for (const auto& stroke : plan_.strokes) accepted_->add(stroke.front());
        for (const Vec3& root : along_) accepted_->add(root);
    }

    const FillPlan& plan_;
    const Filler& filler_;
    FillReport& report_;
    std::vector<Vec3> along_;
    std::optional<AcceptedRoots> accepted_;
    FillKind kind_ = FillKind::kAlong;
};

}  // namespace

Result<FillPlan> plan_fill(const Tuft& from, const Tuft* to, const FillSettings& settings, const Head& head,
                           const Limits& limits) {
    if (Check wrong = check_tuft(from, head, limits)) return within("/from", *wrong);
    if (to != nullptr) {
        if (Check wrong = check_tuft(*to, head, limits)) return within("/to", *wrong);
    }
    if (Check wrong = check_fill_settings(settings, limits)) return *wrong;

    const HeadFrame frame(head);
    const Tuft& second = to == nullptr ? from : *to;
    FillPlan plan;
    plan.settings = settings;
    plan.tufts = {shape_of(from), shape_of(second)};
    plan.strokes = {in_head_frame(from, frame), in_head_frame(second, frame)};
    if (Check wrong = equalize(plan)) return *wrong;
    Result<Gap> gap = measure_gap(plan.strokes[0].front(), plan.strokes[1].front(), to == nullptr, settings, limits);
    if (!gap) return gap.error();
    plan.gap = *gap;
    const bool is_printed = settings.formulas == Formulas::kAsPrinted;
    plan.shares = spread_along(plan.gap.along, from.diameter, second.diameter,
                               settings.spacing.value_or(is_printed ? Spacing::kAsPrinted : Spacing::kDiameter));
    plan.rows =
        lay_rows(parent_roots(plan), to != nullptr || is_printed, settings.density, settings.jitter_seed, limits.tufts);
    if (Check wrong = check_size(plan, limits)) return *wrong;
    return plan;
}

Result<Filled> make_fill(const FillPlan& plan, const Head& head, const Scalp* scalp, const Limits& limits,
                         const ForEach& for_each, std::stop_token stop) {
    const Filler filler(plan, head, scalp);
    const std::vector<Placement>& placements = plan.rows.placements;
    std::vector<Filler::Stroke> strokes(placements.size());
    for_each(placements.size(), [&](std::size_t i) {
        if (!stop.stop_requested()) strokes[i] = filler.stroke_of(placements[i]);
    });
    if (stop.stop_requested()) return Error{ErrorCode::kCancelled, "", {}, "", {}, {}};

    Filled filled;
    filled.report.gap = plan.gap;
    filled.report.beyond_hairline = plan.rows.beyond_hairline;
    filled.report.is_resampled = plan.is_resampled;
    Chooser chooser(plan, filler, filled.report);
    for (std::size_t i = 0; i < placements.size(); ++i) {
        if (!chooser.is_chosen(placements[i], strokes[i])) continue;
        filled.tufts.push_back(filler.tuft_of(placements[i], strokes[i].points));
        if (Check wrong = check_reach(filled.tufts.back(), limits)) return *wrong;
        filled.tufts.back().name = plan.settings.name + "_" + std::to_string(filled.tufts.size());
    }
    return filled;
}

}  // namespace tuftwave
