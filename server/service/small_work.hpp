#pragma once

#include <cstddef>

#include "api/routes.hpp"
#include "tuftwave/limits.hpp"

namespace tuftwave::server {

/// Whether it is worth a try to do a computation at once, on the thread that has read the request: handing a tuft to a
/// worker and its answer back takes longer than to mesh it. That thread serves everybody, so all that it does has small
/// limits: a short body, few tufts, few vertices.
bool may_be_small(const Route& route, std::size_t body_bytes);

/// The limits for the try. What they refuse is for a worker, under the limits that hold for everybody.
Limits small_limits(const Limits& limits);

}  // namespace tuftwave::server
