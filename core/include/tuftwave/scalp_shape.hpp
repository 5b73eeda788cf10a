#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "tuftwave/limits.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/result.hpp"

namespace tuftwave {

/// A scalp as an ellipsoid along the head's axes.
struct ScalpEllipsoid {
    std::optional<Vec3> center;  ///< metres; the head's center when empty
    Vec3 radii;                  ///< half its width, height and depth, metres
};

/// A scalp as triangles in model space; it need not be closed.
struct ScalpMesh {
    std::vector<Vec3> positions;                          ///< metres
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< vertices, from 0
};

/// What hair grows on, as a caller describes it; none is no scalp.
using ScalpShape = std::variant<std::monostate, ScalpEllipsoid, ScalpMesh>;

/// @errors  not_finite, out_of_range, too_few, too_many; below "/ellipsoid" or "/mesh"
Check check_scalp_shape(const ScalpShape& shape, const Limits& limits);

}  // namespace tuftwave
