#pragma once

#include "api/operation.hpp"

namespace tuftwave::server {

/// POST /v1/characters/chains: every chain of a GLB or VRM that could be hair.
Answer post_character_chains(const Request& request, const Context& context);

}  // namespace tuftwave::server
