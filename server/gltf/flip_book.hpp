#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stop_token>
#include <vector>

#include "gltf/clip_keys.hpp"
#include "gltf/document.hpp"
#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server::gltf {

/// A moving hairstyle as a mesh per picture, without skins: each hangs on a node of its own, whose scale is 1 while its
/// picture is on show and else 0. For tools that cannot skin. Pictures share triangles and texture coordinates.
class FlipBook {
  public:
    /// Reserves room for everything. @param plan  with a motion
    FlipBook(Document& document, const HairPlan& plan, ClipKeys keys, int material, const nlohmann::json& extras);

    /// Writes every vertex, triangle and key; call after document.allocate(). Leaves tufts out once `stop` is set.
    void fill(const ForEach& for_each, const std::stop_token& stop);

  private:
    struct Page {
        int node;
        int positions, normals, scales;  // accessors
    };

    void reserve_shared();
    void reserve_pages(int root, int material);
    void fill_tuft(std::size_t tuft, std::size_t first_vertex, std::size_t first_index);
    void fill_scales();

    Document& document_;
    const HairPlan& plan_;
    const ClipKeys keys_;
    int uvs_ = 0, indices_ = 0, times_ = 0;  // accessors
    std::vector<Page> pages_;
};

}  // namespace tuftwave::server::gltf
