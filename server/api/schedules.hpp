#pragma once

#include "api/operation.hpp"

namespace tuftwave::server {

/// POST /v1/schedules: an exposure sheet.
Answer post_schedules(const Request& request, const Context& context);

/// GET /v1/schedules: the same by query, to be cached.
Answer get_schedules(const Request& request, const Context& context);

}  // namespace tuftwave::server
