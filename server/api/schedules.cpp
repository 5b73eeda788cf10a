#include "api/schedules.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "api/body.hpp"
#include "api/choices.hpp"
#include "api/entity_tag.hpp"
#include "api/formats.hpp"
#include "api/query_body.hpp"
#include "api/read_nouns.hpp"
#include "api/write_nouns.hpp"
#include "sheets/csv.hpp"
#include "sheets/track_names.hpp"
#include "sheets/xdts.hpp"
#include "tuftwave/schedule.hpp"

namespace tuftwave::server {
namespace {

struct ScheduleRequest {
    Timing timing;
    Formulas formulas = Formulas::kCorrected;
    int repeat = 1;
};

std::variant<ScheduleRequest, Problem> read_request(const JsonValue body, const Limits& limits) {
    ScheduleRequest read;
    FieldProblems problems;
    const Place root;
    Fields fields(body, root, problems);
    fields.member("timing", [&](const JsonValue timing, const Place& place) {
        read_timing(timing, place, problems, limits, read.timing);
    });
    read_formulas(fields, read.formulas);
    fields.integer("repeat", limits.repeat, read.repeat);
    fields.done();
    if (!problems.empty()) return fields_problem(problems.take());
    return read;
}

constexpr std::array<QueryField, 7> kQueryFields{{{"period", "/timing/period"},
                                                  {"fps", "/timing/fps"},
                                                  {"hold", "/timing/hold"},
                                                  {"short_holds", "/timing/short_holds"},
                                                  {"sampling", "/timing/sampling"},
                                                  {"formulas", "/formulas"},
                                                  {"repeat", "/repeat"}}};

Answer answer(const JsonValue body, Format format, const Limits& limits) {
    auto read = read_request(body, limits);
    if (auto* problem = std::get_if<Problem>(&read)) return std::move(*problem);
    const auto& wanted = std::get<ScheduleRequest>(read);
    const Result<Schedule> schedule = make_schedule(wanted.timing, wanted.formulas, limits);
    if (!schedule) return to_problem(schedule.error(), "/timing");
    if (const Check wrong = check_repeat(*schedule, wanted.repeat, limits)) return to_problem(*wrong);
    switch (format) {
        case Format::kXdts:
            return formatted(format,
                             sheets::xdts(*schedule, wanted.repeat, std::vector<std::string>{sheets::kHairTrack}),
                             "sheet", &*schedule);
        case Format::kCsv:
            return formatted(format, sheets::csv(*schedule, wanted.repeat), "sheet", &*schedule);
        default:
            break;
    }
    const nlohmann::ordered_json json{{"schedule", schedule_json(*schedule)}, {"warnings", warnings_json(&*schedule)}};
    return formatted(Format::kJson, json.dump(), "sheet", &*schedule);
}

}  // namespace

Answer post_schedules(const Request& request, const Context& context) {
    if (auto problem = check_query(request, {"format"})) return *std::move(problem);
    auto format = choose_format(request, {Format::kJson, Format::kXdts, Format::kCsv});
    if (auto* problem = std::get_if<Problem>(&format)) return std::move(*problem);
    auto body = read_body(request);
    if (auto* problem = std::get_if<Problem>(&body)) return std::move(*problem);
    return answer(std::get<JsonDocument>(body).root(), std::get<Format>(format), context.limits);
}

Answer get_schedules(const Request& request, const Context& context) {
    if (auto problem = check_query(request, names_of(kQueryFields))) return *std::move(problem);
    auto format = choose_format(request, {Format::kJson, Format::kXdts, Format::kCsv});
    if (auto* problem = std::get_if<Problem>(&format)) return std::move(*problem);
    const JsonDocument body = query_body(request, kQueryFields);
    Answer made = answer(body.root(), std::get<Format>(format), context.limits);
    if (auto* problem = std::get_if<Problem>(&made))
        return as_query_problem(std::move(*problem), kQueryFields, request);
    auto& response = std::get<Response>(made);
    response.headers.emplace_back("Cache-Control", "public, max-age=86400");
    return with_entity_tag(std::move(response), request);
}

}  // namespace tuftwave::server
