#include "service/small_work.hpp"

#include <algorithm>

namespace tuftwave::server {
namespace {

constexpr std::size_t kMostBodyBytes = 2 * 1024;  // read in about as long as a tuft is meshed
constexpr std::size_t kMostTufts = 2;
constexpr std::size_t kMostPoints = 64;
constexpr std::size_t kMostRings = 64;
constexpr std::size_t kMostVertices = 1'024;  // one tuft of 64 rings and 12 sides, or two as they are by themselves
constexpr std::size_t kMostSheetFrames = 240;

}  // namespace

bool may_be_small(const Route& route, const std::size_t body_bytes) {
    return route.may_be_small && body_bytes <= kMostBodyBytes;
}

Limits small_limits(const Limits& limits) {
    Limits small = limits;
    small.tufts = std::min(limits.tufts, kMostTufts);
    small.points = std::min(limits.points, kMostPoints);
    small.points_per_tuft = std::min(limits.points_per_tuft, kMostPoints);
    small.rings_per_tuft = std::min(limits.rings_per_tuft, kMostRings);
    small.vertices = std::min(limits.vertices, kMostVertices);
    small.triangles = std::min(limits.triangles, 2 * kMostVertices);
    small.sheet_frames = std::min(limits.sheet_frames, kMostSheetFrames);
    return small;
}

}  // namespace tuftwave::server
