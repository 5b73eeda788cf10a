#include "api/fills.hpp"

#include <nlohmann/json.hpp>

#include "api/body.hpp"
#include "api/formats.hpp"
#include "api/hair_bytes.hpp"
#include "api/read_nouns.hpp"
#include "api/write_nouns.hpp"
#include "tuftwave/fill.hpp"

namespace tuftwave::server {
namespace {

using Json = nlohmann::ordered_json;

struct FillRequest {
    HairRequest hair;  // without tufts
    Tuft from;
    std::optional<Tuft> to;
    FillSettings settings;
};

void read_fill(const JsonValue value, const Place& place, FieldProblems& problems, const Limits& limits,
               FillRequest& into) {
    Fields fields(value, place, problems);
    fields.require("from");
    fields.member("from",
                  [&](const JsonValue tuft, const Place& at) { read_tuft(tuft, at, problems, limits, into.from); });
    fields.optional_member(
        "to", [&](const JsonValue tuft, const Place& at) { read_tuft(tuft, at, problems, limits, into.to.emplace()); });
    read_fill_settings(fields, problems, into.settings);
    read_formulas(fields, into.settings.formulas);
    fields.done();
}

std::variant<FillRequest, Problem> read_request(const JsonValue body, const Limits& limits) {
    FillRequest read;
    FieldProblems problems;
    const Place root;
    Fields fields(body, root, problems);
    fields.require("fill");
    fields.member("head", [&](const JsonValue head, const Place& place) {
        read_head(head, place, problems, limits, read.hair.hairstyle.head);
    });
    fields.member("fill",
                  [&](const JsonValue fill, const Place& place) { read_fill(fill, place, problems, limits, read); });
    fields.member("mesh", [&](const JsonValue mesh, const Place& place) {
        read_mesh(mesh, place, problems, limits, read.hair.hairstyle.mesh, read.hair.look);
    });
    fields.done();
    if (!problems.empty()) return fields_problem(problems.take());
    return read;
}

Result<Filled> fill(const FillRequest& request, const Context& context) {
    const Head& head = request.hair.hairstyle.head;
    if (Check wrong = check_head(head, context.limits)) return within("/head", *wrong);
    if (Check wrong = check_detail(request.hair.hairstyle.mesh, context.limits)) return within("/mesh", *wrong);
    const Result<FillPlan> plan =
        plan_fill(request.from, request.to ? &*request.to : nullptr, request.settings, head, context.limits);
    if (!plan) return within("/fill", plan.error());
    const std::optional<Scalp> scalp = Scalp::of(head);
    Result<Filled> filled =
        make_fill(*plan, head, scalp ? &*scalp : nullptr, context.limits, context.for_each, context.stop);
    if (!filled) return within("/fill", filled.error());
    return filled;
}

std::string answer_json(const Filled& filled) {
    Json tufts = Json::array();
    for (const Tuft& tuft : filled.tufts) tufts.push_back(tuft_json(tuft));
    return Json{{"tufts", std::move(tufts)},
                {"report", fill_report_json(filled.report)},
                {"warnings", warnings_json(nullptr, {&filled.report, 1})}}
        .dump();
}

/// What is wrong with filled tufts, which the request does not hold, is wrong with the fill.
Error at_fill(Error error) {
    if (error.field.starts_with("/tufts")) error.field = "/fill";
    return error;
}

Answer answer_file(HairRequest hair, Filled filled, Format format, const FileOptions& options, const Context& context) {
    if (filled.tufts.empty())
        return fields_problem({{ProblemCode::kTooFew,
                                "/fill/density",
                                0.0,
                                "a density that gives at least one tuft, since a mesh was asked for",
                                {},
                                {}}});
    hair.hairstyle.tufts = std::move(filled.tufts);
    const Result<HairPlan> plan = plan_hairstyle(hair.hairstyle, context.limits, context.for_each, context.stop);
    if (!plan) return to_problem(at_fill(plan.error()));
    return formatted(format, hair_bytes(hair, *plan, format, context, options), "fill", nullptr);
}

}  // namespace

Answer post_fills(const Request& request, const Context& context) {
    if (auto problem = check_query(request, {"format", "compression"})) return *std::move(problem);
    auto chosen = choose_format(request, {Format::kJson, Format::kGlb, Format::kGltf});
    if (auto* problem = std::get_if<Problem>(&chosen)) return std::move(*problem);
    const Format format = std::get<Format>(chosen);
    auto options = read_file_options(request, format, context.limits);
    if (auto* problem = std::get_if<Problem>(&options)) return std::move(*problem);
    auto body = read_body(request);
    if (auto* problem = std::get_if<Problem>(&body)) return std::move(*problem);
    auto read = read_request(std::get<JsonDocument>(body).root(), context.limits);
    if (auto* problem = std::get_if<Problem>(&read)) return std::move(*problem);

    auto& wanted = std::get<FillRequest>(read);
    Result<Filled> filled = fill(wanted, context);
    if (!filled) return to_problem(filled.error());
    if (format != Format::kJson)
        return answer_file(std::move(wanted.hair), std::move(filled).value(), format, std::get<FileOptions>(options),
                           context);
    return formatted(format, answer_json(*filled), "fill", nullptr);
}

}  // namespace tuftwave::server
