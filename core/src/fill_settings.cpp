#include "tuftwave/fill_settings.hpp"

namespace tuftwave {
namespace {

Check check_density(const std::optional<double>& density, const std::string& field, const Limits& limits) {
    if (!is_on(density)) return {};
    Check wrong = check_range(*density, limits.density, field);
    if (wrong) wrong->allowed += ", or 0 or null for none";
    return wrong;
}

}  // namespace

Check check_fill_settings(const FillSettings& settings, const Limits& limits) {
    if (Check wrong = check_density(settings.density.along, "/density/along", limits)) return wrong;
    if (Check wrong = check_density(settings.density.crown, "/density/crown", limits)) return wrong;
    if (Check wrong = check_density(settings.density.neck, "/density/neck", limits)) return wrong;
    if (settings.tufts_per_meter) {
        if (Check wrong = check_range(*settings.tufts_per_meter, limits.tufts_per_meter, "/tufts_per_meter"))
            return wrong;
    }
    return check_range(settings.min_gap, limits.min_gap, "/min_gap");
}

}  // namespace tuftwave
