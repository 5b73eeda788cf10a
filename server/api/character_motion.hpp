#pragma once

#include "api/operation.hpp"

namespace tuftwave::server {

/// POST /v1/characters/motion: a GLB or VRM with a held clip of its hair added.
Answer post_character_motion(const Request& request, const Context& context);

}  // namespace tuftwave::server
