// Based on: our own. The usual formula divides what is left of a small cosine in two places, z and y, whose errors near
// a pole do not cancel. Here z is taken first, and x and y from what is left once z is undone.
#include "poses/euler.hpp"

#include "tuftwave/elementary.hpp"

namespace tuftwave::server::poses {

ZxyAngles zxy_angles(const Quat& q) {
    const Vec3 x_axis = rotated(q, {1, 0, 0}), y_axis = rotated(q, {0, 1, 0}), z_axis = rotated(q, {0, 0, 1});
    const double z = elementary::atan2(-y_axis.x, y_axis.y);
    const auto [sine, cosine] = elementary::sincos(z);
    const auto unturned_x = [sine = sine, cosine = cosine](const Vec3& v) { return cosine * v.x + sine * v.y; };
    const double x = elementary::atan2(y_axis.z, cosine * y_axis.y - sine * y_axis.x);
    const double y = elementary::atan2(unturned_x(z_axis), unturned_x(x_axis));
    return {z, x, y};
}

}  // namespace tuftwave::server::poses
