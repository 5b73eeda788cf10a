#pragma once

#include <optional>
#include <string_view>

#include "api/operation.hpp"

namespace tuftwave::server {

/// GET /: the studio, or the page of /docs where the server was built without it.
Answer get_root(const Request& request, const Context& context);

/// GET /studio/{file}: a file of the studio's page.
Answer get_studio_file(const Request& request, const Context& context);

/// How a built-in file is found by its name; asset() is one.
using FindAsset = std::optional<std::string_view> (*)(std::string_view name);

/// The two above with files of the caller's own, because a program has either a studio or none, and tests want both.
Answer answer_root(const Request& request, const Context& context, FindAsset find);
Answer answer_studio_file(const Request& request, FindAsset find);

}  // namespace tuftwave::server
