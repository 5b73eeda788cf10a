#pragma once

#include "tuftwave/math.hpp"

namespace tuftwave::server::poses {

/// Angles in radians of the turns about Z, then the turned X, then the turned Y: Rz * Rx * Ry.
struct ZxyAngles {
    double z, x, y;
};

/// The angles of a rotation, as exact near the poles (x = 90 degrees) as anywhere. @param q  unit
ZxyAngles zxy_angles(const Quat& q);

}  // namespace tuftwave::server::poses
