#include "api/fits.hpp"

#include <nlohmann/json.hpp>

#include "api/body.hpp"
#include "api/choices.hpp"
#include "api/drawn_lines.hpp"
#include "api/formats.hpp"
#include "api/read_nouns.hpp"
#include "api/write_nouns.hpp"
#include "tuftwave/fit.hpp"

namespace tuftwave::server {
namespace {

using Json = nlohmann::ordered_json;

struct FitRequest {
    std::vector<Drawing> drawn;
    FitSettings settings;
    std::optional<Timing> timing;
    Formulas formulas = Formulas::kCorrected;
};

std::variant<FitRequest, Problem> read_request(const JsonValue body, const Limits& limits) {
    FitRequest read;
    FieldProblems problems;
    const Place root;
    Fields fields(body, root, problems);
    fields.require("drawn");
    fields.elements("drawn", limits.chains, read.drawn, [&](const JsonValue value, const Place& place, Drawing& lines) {
        read_fitted_lines(value, place, problems, limits, lines);
    });
    fields.choice("mode", kModes, read.settings.mode);
    fields.vector("wind", read.settings.wind);
    fields.vector("up", read.settings.up);
    fields.optional_member("timing", [&](const JsonValue timing, const Place& place) {
        read_timing(timing, place, problems, limits, read.timing.emplace());
    });
    read_formulas(fields, read.formulas);
    fields.integer("cycles", limits.cycles, read.settings.cycles);
    fields.integer("steps", limits.fit_steps, read.settings.steps);
    fields.done();
    if (!problems.empty()) return fields_problem(problems.take());
    return read;
}

Json warning_json(FitWarning warning) {
    switch (warning) {
        case FitWarning::kTwoPictures:
            return {{"code", "two_pictures"},
                    {"detail",
                     "From two pictures nobody can tell which way the wave runs: spatial_period may as well be "
                     "negative."}};
        case FitWarning::kDroopNotIdentifiable:
            return {{"code", "droop_not_identifiable"},
                    {"detail", "The pictures tell amplitude / lightness, but not the two by themselves."}};
        case FitWarning::kStill:
            return {{"code", "nothing_moves"},
                    {"detail", "The pictures do not differ: spatial_period, tip_exponent and phase mean nothing."}};
        case FitWarning::kNoBetterThanStill:
            break;
    }
    return no_better_than_still_json();
}

Json fit_json(const std::string& name, const Fit& fit) {
    Json nodes = Json::array(), warnings = Json::array();
    for (const Vec3& node : fit.rest) nodes.push_back({node.x, node.y, node.z});
    for (const FitWarning warning : fit.warnings) warnings.push_back(warning_json(warning));
    return {{"name", name},
            {"wave", wave_json(fit.wave)},
            {"phase", fit.phase},
            {"cycles", fit.cycles},
            {"nodes", std::move(nodes)},
            {"error", error_json(fit.error)},
            {"still", error_json(fit.still)},
            {"steps", fit.steps},
            {"complete", fit.is_complete},
            {"warnings", std::move(warnings)}};
}

std::string answer_json(const FitRequest& request, const std::vector<Fit>& fits, const Schedule* schedule) {
    Json waves = Json::array();
    std::vector<MotionError> errors, stills;
    std::vector<std::size_t> segments;
    for (std::size_t i = 0; i < fits.size(); ++i) {
        waves.push_back(fit_json(request.drawn[i].name, fits[i]));
        errors.push_back(fits[i].error);
        stills.push_back(fits[i].still);
        segments.push_back(fits[i].rest.size() - 1);
    }
    return Json{{"error", error_json(error_in_all(errors, segments))},
                {"still", error_json(error_in_all(stills, segments))},
                {"fits", std::move(waves)},
                {"warnings", warnings_json(schedule)}}
        .dump();
}

}  // namespace

Answer post_fits(const Request& request, const Context& context) {
    if (auto problem = check_query(request, {"format"})) return *std::move(problem);
    auto chosen = choose_format(request, {Format::kJson});
    if (auto* problem = std::get_if<Problem>(&chosen)) return std::move(*problem);
    auto body = read_body(request);
    if (auto* problem = std::get_if<Problem>(&body)) return std::move(*problem);
    auto read = read_request(std::get<JsonDocument>(body).root(), context.limits);
    if (auto* problem = std::get_if<Problem>(&read)) return std::move(*problem);

    const auto& wanted = std::get<FitRequest>(read);
    if (const Check wrong = check_drawings(wanted.drawn, context.limits)) return to_problem(within("/drawn", *wrong));
    std::optional<Schedule> schedule;
    if (wanted.timing) {
        const Result<Schedule> made = make_schedule(*wanted.timing, wanted.formulas, context.limits);
        if (!made) return to_problem(within("/timing", made.error()));
        schedule = *made;
    }
    const Schedule* when = schedule ? &*schedule : nullptr;
    const auto fits = fit_waves(wanted.drawn, wanted.settings, when, context.limits, context.for_each, context.stop);
    if (!fits) return to_problem(fits.error());
    return formatted(Format::kJson, answer_json(wanted, *fits, when), "fit", nullptr);
}

}  // namespace tuftwave::server
