#include "tuftwave/vector_checks.hpp"

namespace tuftwave {

Check check_position(const Vec3& position, const Limits& limits, const std::string& field) {
    const double coordinates[] = {position.x, position.y, position.z};
    for (int axis = 0; axis < 3; ++axis) {
        if (is_within(coordinates[axis], limits.coordinate)) continue;
        return check_range(coordinates[axis], limits.coordinate, field + "/" + std::to_string(axis));
    }
    return {};
}

Check check_direction(const Vec3& direction, const Limits& limits, const std::string& field) {
    if (Check wrong = check_position(direction, limits, field)) return wrong;
    if (dot(direction, direction) < kShortestDirection * kShortestDirection)
        return Error{ErrorCode::kDegenerate, field, length(direction), "a vector with a length above 1e-9", {}, {}};
    return {};
}

Check check_not_parallel(const Vec3& a, const Vec3& b, const std::string& field, const std::string& other) {
    const Vec3 unit = normalized(b);
    if (length(rejected(normalized(a), unit)) > kSmallestSine) return {};
    return Error{ErrorCode::kDegenerate,
                 field,
                 std::string("parallel to ") + other,
                 "a direction not parallel to " + other,
                 {},
                 {}};
}

}  // namespace tuftwave
