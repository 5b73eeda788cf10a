#include "api/formats.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "api/write_nouns.hpp"

namespace tuftwave::server {
namespace {

struct Row {
    Format format;
    std::string_view word;  // of ?format= and of the file name
    std::string_view media_type;
};

constexpr std::array<Row, 8> kTable{{{Format::kGlb, "glb", "model/gltf-binary"},
                                     {Format::kGltf, "gltf", "model/gltf+json"},
                                     {Format::kJson, "json", "application/json"},
                                     {Format::kXdts, "xdts", "application/x-xdts+json"},
                                     {Format::kCsv, "csv", "text/csv"},
                                     {Format::kVmd, "vmd", "application/octet-stream"},
                                     {Format::kBvh, "bvh", "application/x-bvh"},
                                     {Format::kUsda, "usda", "model/vnd.usda"}}};

const Row& row(Format format) { return kTable[static_cast<std::size_t>(format)]; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

/// Cuts off and returns what stands before the next `mark`.
std::string_view next_part(std::string_view& rest, char mark) {
    const std::size_t end = rest.find(mark);
    const std::string_view part = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return trimmed(part);
}

double quality_of(std::string_view parameters) {
    while (!parameters.empty()) {
        const std::string_view parameter = next_part(parameters, ';');
        if (!parameter.starts_with("q=")) continue;
        double quality = 0;
        std::from_chars(parameter.data() + 2, parameter.data() + parameter.size(), quality);
        return quality;
    }
    return 1;
}

/// How well a media range fits a type: 0 not at all, 1 "*/*", 2 "model/*", 3 exactly.
int fit(std::string_view range, std::string_view type) {
    if (range == type) return 3;
    if (range == "*/*") return 1;
    return range.ends_with("/*") && type.starts_with(range.substr(0, range.size() - 1)) ? 2 : 0;
}

/// The quality that an Accept header gives to a type; the most specific range decides (RFC 9110, 12.5.1).
double accepted_quality(std::string_view accept, std::string_view type) {
    int best_fit = 0;
    double quality = 0;
    while (!accept.empty()) {
        std::string_view element = next_part(accept, ',');
        const int fits = fit(next_part(element, ';'), type);
        if (fits <= best_fit) continue;
        best_fit = fits;
        quality = quality_of(element);
    }
    return quality;
}

std::string words(std::initializer_list<Format> formats) {
    std::string joined;
    for (const Format format : formats) joined += (joined.empty() ? "" : ", ") + std::string(row(format).word);
    return joined;
}

std::variant<Format, Problem> by_word(const std::string& word, std::initializer_list<Format> offered) {
    for (const Format format : offered) {
        if (row(format).word == word) return format;
    }
    return fields_problem(
        {{ProblemCode::kNotAChoice, "?format", word.substr(0, 64), "one of " + words(offered), {}, {}}});
}

}  // namespace

std::variant<Format, Problem> choose_format(const Request& request, std::initializer_list<Format> offered) {
    for (const auto& [name, value] : request.query) {
        if (name == "format") return by_word(value, offered);
    }
    std::string accept = request.header("accept");
    for (char& c : accept) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    if (trimmed(accept).empty()) return *offered.begin();
    const Format* best = nullptr;
    double best_quality = 0;
    for (const Format& format : offered) {
        const double quality = accepted_quality(accept, row(format).media_type);
        if (quality > best_quality) {
            best = &format;
            best_quality = quality;
        }
    }
    if (best != nullptr) return *best;
    std::string types;
    for (const Format format : offered) types += (types.empty() ? "" : ", ") + std::string(row(format).media_type);
    return Problem{ProblemCode::kNotAcceptable, "Available are " + types + ".", {}, {}};
}

Response formatted(Format format, std::string body, const std::string& name, const Schedule* schedule) {
    Response response{200, std::string(row(format).media_type), std::move(body), {{"Vary", "Accept"}}};
    if (format == Format::kCsv) response.content_type += "; charset=utf-8; header=present";
    std::string file = name;
    if (schedule != nullptr) {
        const std::string rate = frame_rate_text(schedule->fps);
        response.headers.emplace_back("Tuftwave-Frame-Rate", rate);
        file += "_" + rate + "fps";
        std::replace(file.begin(), file.end(), '/', '-');
    }
    const bool is_file = format != Format::kJson;
    if (is_file)
        response.headers.emplace_back("Content-Disposition",
                                      "attachment; filename=\"" + file + "." + std::string(row(format).word) + "\"");
    return response;
}

Response formatted(Format format, gltf::File file, const std::string& name, const Schedule* schedule) {
    Response response = formatted(format, std::move(file.memory), name, schedule);
    response.first = file.first;
    return response;
}

}  // namespace tuftwave::server
