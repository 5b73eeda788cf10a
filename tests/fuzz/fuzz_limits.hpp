#pragma once

#include "tuftwave/limits.hpp"

namespace tuftwave::server::fuzz {

/// Limits under which nothing takes long, so that time goes into many inputs and not into large meshes. How the large
/// ones are refused is the same code with other numbers.
inline Limits small_limits() {
    Limits limits;
    limits.tufts = 256;
    limits.points = 2'048;
    limits.fills = 16;
    limits.scalp_vertices = 256;
    limits.scalp_triangles = 512;
    limits.chains = 256;
    limits.joints = 1'024;
    limits.node_poses = 8'192;
    limits.joint_keys = 8'192;
    limits.drawn_nodes = 64;
    limits.vertices = 8'192;
    limits.triangles = 16'384;
    limits.sheet_frames = 2'880;
    limits.sheet_cells = 8'192;
    return limits;
}

}  // namespace tuftwave::server::fuzz
