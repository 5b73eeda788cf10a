#include "workloads.hpp"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace tuftwave::bench {
namespace {

std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<Line> lines_of(const std::string& text, const char* things, const char* points) {
    const nlohmann::json request = nlohmann::json::parse(text);
    std::vector<Line> lines;
    for (const nlohmann::json& thing : request.at(things)) lines.push_back(thing.at(points).get<Line>());
    return lines;
}

}  // namespace

Workloads read_workloads(const std::string& folder) {
    Workloads read;
    read.strokes_text = text_of(folder + "/w1.json");
    read.chains_text = text_of(folder + "/w2.json");
    read.strokes = lines_of(read.strokes_text, "tufts", "points");
    read.chains = lines_of(read.chains_text, "chains", "nodes");
    return read;
}

}  // namespace tuftwave::bench
