#pragma once

#include <array>
#include <string>
#include <vector>

namespace tuftwave::bench {

using Point = std::array<double, 3>;
using Line = std::vector<Point>;

/// W1 and W2 as every party gets them: the requests that workloads.py writes.
struct Workloads {
    std::string strokes_text, chains_text;  ///< the requests as they are sent
    std::vector<Line> strokes, chains;      ///< metres, root first
};

/// @param folder  with w1.json and w2.json
/// Throws where they cannot be read.
Workloads read_workloads(const std::string& folder);

}  // namespace tuftwave::bench
