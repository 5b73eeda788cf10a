#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "api/operation.hpp"

namespace tuftwave::server {

/// One operation at one place.
struct Route {
    std::string_view method, path;  ///< a path may end in "{file}", which stands for one segment
    Operation run;
    bool computes;              ///< takes a worker; the others answer at once on the connection's own thread
    bool takes_file = false;    ///< its body is a file, not JSON, and may be larger
    bool may_be_small = false;  ///< small limits on counts bound its time, too: no search, no solver, no head to read
};

/// The one table of routes.
std::span<const Route> routes();

/// The route of a request, or not_found or method_not_allowed with Allow. HEAD is served by GET.
std::variant<const Route*, Problem> find_route(const std::string& method, const std::string& path);

/// The largest body that a request for a path may have, bytes.
std::size_t body_limit(const std::string& path);

/// The methods of a path for an Allow header, "" where there is nothing.
std::string allowed_methods(const std::string& path);

}  // namespace tuftwave::server
