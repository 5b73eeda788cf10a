#pragma once

#include "api/operation.hpp"

namespace tuftwave::server {

/// POST /v1/fills: the tufts between two tufts.
Answer post_fills(const Request& request, const Context& context);

}  // namespace tuftwave::server
