#pragma once

#include "api/operation.hpp"

namespace tuftwave::server {

/// POST /v1/evaluations: how far lines, or a motion, are from drawn ones.
Answer post_evaluations(const Request& request, const Context& context);

}  // namespace tuftwave::server
