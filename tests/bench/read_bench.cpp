// A request's JSON, from text to core's structs, beside what nlohmann's parser alone takes for the same text.

#include <benchmark/benchmark.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "api/body.hpp"
#include "api/read_nouns.hpp"

namespace tuftwave::server {
namespace {

double rounded(double value) { return std::round(value * 1e6) / 1e6; }

/// A lock that hangs from a head of 9 to 10 cm, bending outwards, as thousand_strokes.py draws it.
nlohmann::json stroke(int index) {
    constexpr double kGoldenAngle = 2.399963;
    nlohmann::json points = nlohmann::json::array();
    for (int k = 0; k < 8; ++k) {
        const double out = (0.09 + 0.0001 * (index % 97)) * (1 + 0.12 * k - 0.01 * k * k);
        points.push_back({rounded(out * std::sin(kGoldenAngle * index)), rounded(0.1 - 0.03 * k),
                          rounded(out * std::cos(kGoldenAngle * index))});
    }
    return {{"points", std::move(points)}};
}

std::string body_of(std::int64_t strokes) {
    nlohmann::json body{{"tufts", nlohmann::json::array()},
                        {"mesh", {{"rings", 64}, {"sides", 12}, {"layout", "merged"}}}};
    for (int i = 0; i < strokes; ++i) body["tufts"].push_back(stroke(i));
    std::string text;
    for (const char c : body.dump()) {  // with the spaces that Python writes
        text += c;
        if (c == ',' || c == ':') text += ' ';
    }
    return text;
}

std::vector<Tuft> read_tufts(const std::string& body) {
    const Limits limits;
    const auto parsed = parse_guarded(body, JsonLimits{});
    std::vector<Tuft> tufts;
    FieldProblems problems;
    const Place root;
    Fields fields(std::get<JsonDocument>(parsed).root(), root, problems);
    fields.elements("tufts", limits.tufts, tufts, [&](const JsonValue value, const Place& place, Tuft& tuft) {
        read_tuft(value, place, problems, limits, tuft);
    });
    MeshDetail detail;
    gltf::Look look;
    fields.member("mesh", [&](const JsonValue value, const Place& place) {
        read_mesh(value, place, problems, limits, detail, look);
    });
    fields.done();
    if (!problems.empty()) tufts.clear();
    return tufts;
}

void rate(benchmark::State& state, const std::string& body) {
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(body.size()));
}

void bm_read_request(benchmark::State& state) {
    const std::string body = body_of(state.range(0));
    if (read_tufts(body).size() != static_cast<std::size_t>(state.range(0))) state.SkipWithError("it is not read");
    for (auto _ : state) benchmark::DoNotOptimize(read_tufts(body));
    rate(state, body);
}
BENCHMARK(bm_read_request)->Arg(1)->Arg(1'000)->ArgName("strokes")->Unit(benchmark::kMicrosecond);

void bm_nlohmann_parse(benchmark::State& state) {
    const std::string body = body_of(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(nlohmann::json::parse(body));
    rate(state, body);
}
BENCHMARK(bm_nlohmann_parse)->Arg(1)->Arg(1'000)->ArgName("strokes")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace tuftwave::server
