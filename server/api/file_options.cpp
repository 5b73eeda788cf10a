#include "api/file_options.hpp"

#include <array>

#include "api/choices.hpp"
#include "api/query_body.hpp"
#include "api/reader.hpp"

namespace tuftwave::server {
namespace {

constexpr std::array<QueryField, 4> kQueryFields{{{"repeat", "/repeat"},
                                                  {"interpolation", "/interpolation", QueryValue::kText},
                                                  {"clip", "/clip", QueryValue::kText},
                                                  {"compression", "/compression", QueryValue::kText}}};

Problem no_use(const std::string& pointer, const std::string& given, const std::string& allowed) {
    return fields_problem({{ProblemCode::kConflict, pointer, given, allowed, {}, {}}});
}

bool has_clip(Format format) { return format == Format::kGlb || format == Format::kGltf; }
bool repeats(Format format) { return format == Format::kXdts || format == Format::kCsv || format == Format::kVmd; }

}  // namespace

std::variant<FileOptions, Problem> read_file_options(const Request& request, Format format, const Limits& limits) {
    const JsonDocument body = query_body(request, kQueryFields);
    FileOptions read;
    FieldProblems problems;
    const Place root;
    Fields fields(body.root(), root, problems);
    fields.integer("repeat", limits.repeat, read.repeat);
    fields.choice("interpolation", kHoldings, read.holding);
    fields.choice("clip", kClipKinds, read.kind);
    fields.choice("compression", kCompressions, read.compression);
    fields.done();
    if (!problems.empty()) return as_query_problem(fields_problem(problems.take()), kQueryFields, request);
    if (read.repeat != 1 && !repeats(format))
        return no_use("?repeat", std::to_string(read.repeat), "1; only xdts, csv and vmd write several cycles");
    if (read.holding != gltf::Holding::kStep && !has_clip(format))
        return no_use("?interpolation", std::string(word_of(kHoldings, read.holding)),
                      "step; only glb and gltf have clips");
    if (read.kind != gltf::ClipKind::kSkeleton && !has_clip(format))
        return no_use("?clip", std::string(word_of(kClipKinds, read.kind)), "skeleton; only glb and gltf have clips");
    const bool is_packed = read.compression != gltf::Compression::kNone;
    if (is_packed && (format != Format::kGlb || read.kind == gltf::ClipKind::kFlipBook))
        return no_use("?compression", std::string(word_of(kCompressions, read.compression)),
                      "none; only glb is packed, and no flip book");
    return read;
}

}  // namespace tuftwave::server
