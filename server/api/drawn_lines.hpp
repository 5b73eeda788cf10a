#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "api/reader.hpp"
#include "tuftwave/fit.hpp"
#include "tuftwave/measure.hpp"

namespace tuftwave::server {

// Drawn lines as JSON, and how far others are from them.

/// A chain's pictures, to be compared.
struct ComparedLines {
    std::string name;
    std::vector<Line> pictures;
    std::optional<double> rest_length;
};

void read_compared_lines(JsonValue json, const Place& place, FieldProblems& problems, const Limits& limits,
                         ComparedLines& into);
void read_fitted_lines(JsonValue json, const Place& place, FieldProblems& problems, const Limits& limits,
                       Drawing& into);

nlohmann::ordered_json error_json(const LineError& error);
nlohmann::ordered_json error_json(const MotionError& error);

/// The warning of an answer that is no nearer than a still picture.
nlohmann::ordered_json no_better_than_still_json();

}  // namespace tuftwave::server
