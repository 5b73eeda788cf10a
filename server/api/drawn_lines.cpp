#include "api/drawn_lines.hpp"

#include <nlohmann/json.hpp>

#include "api/echo.hpp"
#include "api/read_nouns.hpp"

namespace tuftwave::server {
namespace {

using Json = nlohmann::ordered_json;

/// A line's nodes, each of three numbers, or of two, which lie in the plane z = 0.
void read_line(const JsonValue value, const Place& place, std::size_t most, FieldProblems& problems, Line& into) {
    const auto refuse = [&](const JsonValue given, const Place& at, const char* wanted) {
        problems.add({ProblemCode::kWrongType, at.pointer(), echo(given), wanted, {}, {}});
    };
    if (!value.is_array()) return refuse(value, place, "an array of points");
    const std::size_t count = value.size();
    if (const Check wrong = check_count(count, 0, most, ""))
        return problems.add(to_field_problem(*wrong, place.pointer()));
    into.reserve(count);
    std::size_t i = 0;
    for (const JsonValue point : value.items()) {
        const Place at(place, i++);
        if (!point.is_array() || point.size() < 2 || point.size() > 3) {
            refuse(point, at, "two or three numbers");
            continue;
        }
        double parts[3] = {};
        std::size_t axis = 0;
        for (const JsonValue part : point.items()) {
            if (const auto number = part.number()) {
                parts[axis] = *number;
            } else {
                refuse(part, Place(at, axis), "a number");
            }
            ++axis;
        }
        into.push_back({parts[0], parts[1], parts[2]});
    }
}

void read_pictures(Fields& fields, FieldProblems& problems, const Limits& limits, std::vector<Line>& into) {
    fields.require("pictures");
    fields.elements("pictures", limits.pictures, into, [&](const JsonValue picture, const Place& at, Line& line) {
        read_line(picture, at, limits.nodes_per_chain, problems, line);
    });
}

}  // namespace

void read_compared_lines(const JsonValue value, const Place& place, FieldProblems& problems, const Limits& limits,
                         ComparedLines& into) {
    Fields fields(value, place, problems);
    fields.text("name", kLongestName, into.name);
    read_pictures(fields, problems, limits, into.pictures);
    fields.number("rest_length", into.rest_length);
    fields.done();
}

void read_fitted_lines(const JsonValue value, const Place& place, FieldProblems& problems, const Limits& limits,
                       Drawing& into) {
    Fields fields(value, place, problems);
    fields.text("name", kLongestName, into.name);
    read_pictures(fields, problems, limits, into.pictures);
    fields.optional_member("rest", [&](const JsonValue rest, const Place& at) {
        read_line(rest, at, limits.nodes_per_chain, problems, into.rest.emplace());
    });
    fields.done();
}

Json error_json(const LineError& error) {
    return {{"angle_deg", error.angle / kRadiansPerDegree}, {"position_percent", 100 * error.position}};
}

Json error_json(const MotionError& error) {
    Json whole = error_json(error.mean);
    whole["pictures"] = Json::array();
    for (const LineError& picture : error.pictures) whole["pictures"].push_back(error_json(picture));
    return whole;
}

Json no_better_than_still_json() {
    return {{"code", "no_better_than_still"},
            {"detail", "Holding the mean of the drawn pictures still is as near to the drawing, or nearer."}};
}

}  // namespace tuftwave::server
