#pragma once

#include "api/operation.hpp"

namespace tuftwave::server {

/// POST /v1/tufts: strokes to closed, skinned meshes.
Answer post_tufts(const Request& request, const Context& context);

/// POST /v1/hairstyles: a whole head of hair, moving.
Answer post_hairstyles(const Request& request, const Context& context);

}  // namespace tuftwave::server
