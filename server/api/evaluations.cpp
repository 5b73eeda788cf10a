#include "api/evaluations.hpp"

#include <nlohmann/json.hpp>

#include "api/body.hpp"
#include "api/drawn_lines.hpp"
#include "api/formats.hpp"
#include "api/read_nouns.hpp"
#include "api/write_nouns.hpp"
#include "tuftwave/motion.hpp"
#include "tuftwave/vector_checks.hpp"

namespace tuftwave::server {
namespace {

using Json = nlohmann::ordered_json;

struct EvaluationRequest {
    std::vector<ComparedLines> drawn;
    std::optional<std::vector<ComparedLines>> lines;  // or else the chains with their motion
    std::vector<Chain> chains;
    Motion motion;
    Formulas formulas = Formulas::kCorrected;
};

FieldProblem unequal(const std::string& pointer, std::size_t given, std::size_t drawn, const std::string& what) {
    const auto count = static_cast<double>(drawn);
    return {ProblemCode::kConflict,
            pointer,
            static_cast<double>(given),
            "as many " + what + " as were drawn, " + std::to_string(drawn),
            count,
            count};
}

void read_lines(Fields& fields, std::string_view name, FieldProblems& problems, const Limits& limits,
                std::vector<ComparedLines>& into) {
    fields.elements(name, limits.chains, into, [&](const JsonValue value, const Place& place, ComparedLines& lines) {
        read_compared_lines(value, place, problems, limits, lines);
    });
}

/// What is compared: other lines, or chains and how they move.
void read_compared(Fields& fields, FieldProblems& problems, const Limits& limits, EvaluationRequest& into) {
    bool has_chains = false, has_motion = false;
    fields.optional_member(
        "lines", [&](JsonValue, const Place&) { read_lines(fields, "lines", problems, limits, into.lines.emplace()); });
    fields.optional_member("chains", [&](JsonValue, const Place&) {
        has_chains = true;
        fields.elements("chains", limits.chains, into.chains,
                        [&](const JsonValue value, const Place& place, Chain& chain) {
                            read_chain(value, place, problems, limits, chain);
                        });
    });
    fields.member("motion", [&](const JsonValue motion, const Place& place) {
        has_motion = !motion.is_null() && !(motion.is_nested() && motion.size() == 0);
        read_motion(motion, place, problems, limits, into.motion);
    });
    if (into.lines && has_chains) {
        problems.add({ProblemCode::kConflict, "/lines", {}, "either lines or chains", {}, {}});
    } else if (into.lines && has_motion) {
        problems.add({ProblemCode::kConflict, "/motion", {}, "a motion of chains, not of lines", {}, {}});
    } else if (!into.lines && !has_chains) {
        problems.add({ProblemCode::kMissingField, "/lines", {}, "either lines or chains", {}, {}});
    }
}

std::variant<EvaluationRequest, Problem> read_request(const JsonValue body, const Limits& limits) {
    EvaluationRequest read;
    FieldProblems problems;
    const Place root;
    Fields fields(body, root, problems);
    fields.require("drawn");
    read_lines(fields, "drawn", problems, limits, read.drawn);
    if (body.is_object()) read_compared(fields, problems, limits, read);
    read_formulas(fields, read.formulas);
    fields.done();
    if (!problems.empty()) return fields_problem(problems.take());
    return read;
}

/// @errors  too_few, too_many (chains); those of check_lines below "/0/pictures" ...; out_of_range (a rest length)
Check check_all(std::span<const ComparedLines> all, const Limits& limits) {
    if (Check wrong = check_count(all.size(), 1, limits.chains, "")) return wrong;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string place = "/" + std::to_string(i);
        if (Check wrong = check_lines(all[i].pictures, limits)) return within(place + "/pictures", *wrong);
        if (all[i].rest_length) {
            if (Check wrong = check_range(*all[i].rest_length, limits.rest_length, place + "/rest_length"))
                return wrong;
        }
    }
    return {};
}

/// The length that distances are measured by. @errors  degenerate
Result<double> rest_length(const ComparedLines& drawn, const std::string& place) {
    const double rest_length = drawn.rest_length.value_or(mean_length(drawn.pictures));
    if (rest_length >= kShortestDirection) return rest_length;
    return Error{
        ErrorCode::kDegenerate, place + "/pictures", {}, "lines that are at least 1e-9 long on average", {}, {}};
}

/// Every chain's lines as its motion has them. @param schedule  set for the caller
Result<std::vector<std::vector<Line>>> moved_lines(const EvaluationRequest& request, const Context& context,
                                                   std::optional<Schedule>& schedule) {
    if (Check wrong = check_chains(request.chains, context.limits)) return within("/chains", *wrong);
    Result<Schedule> made = make_schedule(request.motion.timing, request.formulas, context.limits);
    if (!made) return within("/motion/timing", made.error());
    schedule = *made;
    const auto moved =
        move_chains(request.chains, request.motion, *schedule, context.limits, context.for_each, context.stop);
    if (!moved) return moved.error();
    std::vector<std::vector<Line>> lines(moved->size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::span<const Quat> rotations = (*moved)[i].rotations;
        const std::size_t nodes = request.chains[i].nodes.size();
        for (std::size_t at = 0; at < rotations.size(); at += nodes)
            lines[i].push_back(node_positions(request.chains[i], rotations.subspan(at, nodes)));
    }
    return lines;
}

/// What is wrong where chains, pictures or nodes are not as many as were drawn; pointers name what can be mended.
std::optional<FieldProblem> check_counts(const EvaluationRequest& request,
                                         const std::vector<std::vector<Line>>& compared) {
    const std::string list = request.lines ? "/lines" : "/chains";
    if (compared.size() != request.drawn.size()) return unequal(list, compared.size(), request.drawn.size(), "chains");
    for (std::size_t i = 0; i < compared.size(); ++i) {
        const std::vector<Line>&drawn = request.drawn[i].pictures, &lines = compared[i];
        const std::string place = list + "/" + std::to_string(i);
        if (lines.size() != drawn.size())
            return unequal(request.lines ? place + "/pictures" : "/motion/timing", lines.size(), drawn.size(),
                           "pictures");
        const std::size_t given = lines.front().size(), wanted = drawn.front().size();
        if (given != wanted)
            return unequal(request.lines ? place + "/pictures/0" : place + "/nodes", given, wanted, "nodes");
    }
    return {};
}

struct Evaluation {
    std::vector<MotionError> errors, stills;
    std::vector<std::size_t> segments;
};

Result<Evaluation> evaluate(const EvaluationRequest& request, const std::vector<std::vector<Line>>& compared) {
    Evaluation evaluation;
    for (std::size_t i = 0; i < compared.size(); ++i) {
        const std::vector<Line>& drawn = request.drawn[i].pictures;
        const Result<double> length = rest_length(request.drawn[i], "/drawn/" + std::to_string(i));
        if (!length) return length.error();
        evaluation.errors.push_back(*measure_error(compared[i], drawn, *length));
        evaluation.stills.push_back(still_error(drawn, *length));
        evaluation.segments.push_back(drawn.front().size() - 1);
    }
    return evaluation;
}

std::string answer_json(const EvaluationRequest& request, const Evaluation& evaluation,
                        const std::optional<Schedule>& schedule) {
    Json chains = Json::array();
    for (std::size_t i = 0; i < request.drawn.size(); ++i) {
        chains.push_back({{"name", request.drawn[i].name},
                          {"error", error_json(evaluation.errors[i])},
                          {"still", error_json(evaluation.stills[i])}});
    }
    const LineError error = error_in_all(evaluation.errors, evaluation.segments);
    const LineError still = error_in_all(evaluation.stills, evaluation.segments);
    Json warnings = warnings_json(schedule ? &*schedule : nullptr);
    if (error.position > 0 && error.position >= still.position) warnings.push_back(no_better_than_still_json());
    return Json{{"error", error_json(error)},
                {"still", error_json(still)},
                {"chains", std::move(chains)},
                {"warnings", std::move(warnings)}}
        .dump();
}

}  // namespace

Answer post_evaluations(const Request& request, const Context& context) {
    if (auto problem = check_query(request, {"format"})) return *std::move(problem);
    auto chosen = choose_format(request, {Format::kJson});
    if (auto* problem = std::get_if<Problem>(&chosen)) return std::move(*problem);
    auto body = read_body(request);
    if (auto* problem = std::get_if<Problem>(&body)) return std::move(*problem);
    auto read = read_request(std::get<JsonDocument>(body).root(), context.limits);
    if (auto* problem = std::get_if<Problem>(&read)) return std::move(*problem);

    const auto& wanted = std::get<EvaluationRequest>(read);
    if (const Check wrong = check_all(wanted.drawn, context.limits)) return to_problem(within("/drawn", *wrong));
    std::vector<std::vector<Line>> compared;
    std::optional<Schedule> schedule;
    if (wanted.lines) {
        if (const Check wrong = check_all(*wanted.lines, context.limits)) return to_problem(within("/lines", *wrong));
        for (const ComparedLines& lines : *wanted.lines) compared.push_back(lines.pictures);
    } else {
        auto moved = moved_lines(wanted, context, schedule);
        if (!moved) return to_problem(moved.error());
        compared = std::move(moved).value();
    }
    if (auto problem = check_counts(wanted, compared)) return fields_problem({*std::move(problem)});
    const Result<Evaluation> evaluation = evaluate(wanted, compared);
    if (!evaluation) return to_problem(evaluation.error());
    return formatted(Format::kJson, answer_json(wanted, *evaluation, schedule), "evaluation", nullptr);
}

}  // namespace tuftwave::server
