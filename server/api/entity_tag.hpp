#pragma once

#include "api/exchange.hpp"

namespace tuftwave::server {

/// Adds a strong ETag, a hash of the body's exact bytes: the same on every replica. Whoever says in If-None-Match that
/// they have it gets 304 without a body. Bytes that live as long as the program are hashed once. Thread-safe.
Response with_entity_tag(Response response, const Request& request);

}  // namespace tuftwave::server
