#include "tuftwave/vector_checks.hpp"

#include <string>

namespace tuftwave {
namespace {

std::string item_of(std::string_view list, std::size_t item) {
    return std::string(list).append("/").append(std::to_string(item));
}

}  // namespace

Check check_position(const Vec3& position, const Limits& limits, std::string_view field) {
    const double coordinates[] = {position.x, position.y, position.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (is_within(coordinates[axis], limits.coordinate)) continue;
        return check_range(coordinates[axis], limits.coordinate, item_of(field, axis));
    }
    return {};
}

Check check_positions(std::span<const Vec3> positions, const Limits& limits, std::string_view field) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        // Its place is only made text if it must be said.
        if (Check wrong = check_position(positions[i], limits, "")) return within(item_of(field, i), *std::move(wrong));
    }
    return {};
}

Check check_direction(const Vec3& direction, const Limits& limits, std::string_view field) {
    if (Check wrong = check_position(direction, limits, field)) return wrong;
    if (dot(direction, direction) < kShortestDirection * kShortestDirection)
        return Error{
            ErrorCode::kDegenerate, std::string(field), length(direction), "a vector with a length above 1e-9", {}, {}};
    return {};
}

Check check_not_parallel(const Vec3& a, const Vec3& b, std::string_view field, std::string_view other) {
    const Vec3 unit = normalized(b);
    if (length(rejected(normalized(a), unit)) > kSmallestSine) return {};
    return Error{ErrorCode::kDegenerate,
                 std::string(field),
                 std::string("parallel to ").append(other),
                 std::string("a direction not parallel to ").append(other),
                 {},
                 {}};
}

}  // namespace tuftwave
