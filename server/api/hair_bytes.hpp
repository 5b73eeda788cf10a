#pragma once

#include <string>

#include "api/file_options.hpp"
#include "api/formats.hpp"
#include "api/operation.hpp"
#include "gltf/hair_file.hpp"
#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server {

/// A request's hairstyle and how it wants to look.
struct HairRequest {
    Hairstyle hairstyle;
    gltf::Look look;
};

/// The file of a planned hairstyle. The recipe rides along in it, so that it can be posted back and edited, and so does
/// the sheet as integers.
/// @param format  kGlb or kGltf
gltf::File hair_bytes(const HairRequest& hair, const HairPlan& plan, Format format, const Context& context,
                      const FileOptions& options = {});

}  // namespace tuftwave::server
