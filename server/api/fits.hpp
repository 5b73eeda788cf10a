#pragma once

#include "api/operation.hpp"

namespace tuftwave::server {

/// POST /v1/fits: the waves behind drawn lines.
Answer post_fits(const Request& request, const Context& context);

}  // namespace tuftwave::server
