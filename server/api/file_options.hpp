#pragma once

#include <variant>

#include "api/exchange.hpp"
#include "api/formats.hpp"
#include "api/problem.hpp"
#include "gltf/hair_file.hpp"
#include "tuftwave/limits.hpp"

namespace tuftwave::server {

/// What the query may say about a file, besides its format.
struct FileOptions {
    int repeat = 1;                                            ///< cycles written out: sheets and VMD
    gltf::Holding holding = gltf::Holding::kStep;              ///< ?interpolation= of clips: GLB and glTF
    gltf::ClipKind kind = gltf::ClipKind::kSkeleton;           ///< ?clip= of hairstyles: GLB and glTF
    gltf::Compression compression = gltf::Compression::kNone;  ///< ?compression= of hair: GLB without a flip book
};

/// @return  conflict for an option that the format knows nothing of, unless it has its default
std::variant<FileOptions, Problem> read_file_options(const Request& request, Format format, const Limits& limits);

}  // namespace tuftwave::server
