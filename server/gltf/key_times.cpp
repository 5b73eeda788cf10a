#include "gltf/key_times.hpp"

#include <cmath>

namespace tuftwave::server::gltf {
namespace {

float largest_below(double seconds) {
    const auto nearest = static_cast<float>(seconds);
    return static_cast<double>(nearest) < seconds ? nearest : std::nextafter(nearest, 0.0F);
}

}  // namespace

std::vector<float> key_times(const Schedule& schedule) {
    const auto seconds = [&](int frame) {
        return static_cast<double>(frame * schedule.fps.denominator) / static_cast<double>(schedule.fps.numerator);
    };
    std::vector<float> times{0.0F};
    for (int n = 1; n < schedule.pictures; ++n)
        times.push_back(largest_below(seconds(schedule.starts[static_cast<std::size_t>(n)])));
    times.push_back(largest_below(seconds(schedule.frames)));
    return times;
}

}  // namespace tuftwave::server::gltf
