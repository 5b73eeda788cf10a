#pragma once

#include <array>
#include <span>

namespace tuftwave::server::gltf {

/// The smallest box around points, metres.
struct Bounds {
    std::array<float, 3> least, most;

    /// Makes it large enough for another one, too.
    void include(const Bounds& other);
};

/// @param points  3 numbers each, finite, at least one point
Bounds bounds_of(std::span<const float> points);

}  // namespace tuftwave::server::gltf
