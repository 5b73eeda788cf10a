#include "api/studio.hpp"

#include <array>
#include <string>

#include "api/about.hpp"
#include "api/entity_tag.hpp"
#include "assets/assets.hpp"

namespace tuftwave::server {
namespace {

constexpr std::string_view kIndex = "index.html";

struct Type {
    std::string_view ending, type;
};
constexpr std::array<Type, 10> kTypes{{{".html", "text/html; charset=utf-8"},
                                       {".js", "text/javascript; charset=utf-8"},
                                       {".css", "text/css; charset=utf-8"},
                                       {".json", "application/json"},
                                       {".glb", "model/gltf-binary"},
                                       {".svg", "image/svg+xml"},
                                       {".png", "image/png"},
                                       {".webp", "image/webp"},
                                       {".woff2", "font/woff2"},
                                       {".txt", "text/plain; charset=utf-8"}}};

/// What the page may load: only what this server has, and what the page itself has made (blob:) or been given (data:),
/// such as a dropped character's textures. Styles may stand in the page, since positions over the drawing are set so.
constexpr std::string_view kContentSecurityPolicy =
    "default-src 'self'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' blob: data:; "
    "connect-src 'self' blob: data:; worker-src 'self' blob:; object-src 'none'; base-uri 'none'; "
    "form-action 'self'; frame-ancestors 'self'";

std::string_view type_of(const std::string_view name) {
    for (const Type& type : kTypes) {
        if (name.ends_with(type.ending)) return type.type;
    }
    return "application/octet-stream";
}

std::optional<Response> studio_file(const std::string_view name, const Request& request, FindAsset find) {
    const auto content = find("studio/" + std::string(name));
    if (!content) return {};
    Response response{200, std::string(type_of(name)), "", {{"Cache-Control", "no-cache"}}, *content};
    if (name.ends_with(".html")) response.headers.emplace_back("Content-Security-Policy", kContentSecurityPolicy);
    return with_entity_tag(std::move(response), request);
}

}  // namespace

Answer answer_root(const Request& request, const Context& context, FindAsset find) {
    if (auto page = studio_file(kIndex, request, find)) return *std::move(page);
    return with_entity_tag(std::get<Response>(get_docs(request, context)), request);
}

Answer answer_studio_file(const Request& request, FindAsset find) {
    const std::string_view name = std::string_view(request.path).substr(std::string_view("/studio/").size());
    if (auto file = studio_file(name, request, find)) return *std::move(file);
    return Problem{ProblemCode::kNotFound, "", {}, {}};
}

Answer get_root(const Request& request, const Context& context) { return answer_root(request, context, asset); }

Answer get_studio_file(const Request& request, const Context&) { return answer_studio_file(request, asset); }

}  // namespace tuftwave::server
