#pragma once

#include "api/operation.hpp"

namespace tuftwave::server {

/// POST /v1/motions: the hair wave on the caller's own chains.
Answer post_motions(const Request& request, const Context& context);

}  // namespace tuftwave::server
