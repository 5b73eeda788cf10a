#include "gltf/clip_keys.hpp"

#include <algorithm>
#include <cmath>

#include "gltf/key_times.hpp"

namespace tuftwave::server::gltf {
namespace {

constexpr double kChange = 1e-3;  // of a frame, in which one held picture turns into the next: too short to be seen

ClipKeys stepped(const Schedule& schedule) {
    ClipKeys keys{key_times(schedule), {}, true};
    for (std::size_t n = 0; n < keys.times.size(); ++n)
        keys.pictures.push_back(n % static_cast<std::size_t>(schedule.pictures));
    return keys;
}

ClipKeys held(const Schedule& schedule) {
    const ClipKeys steps = stepped(schedule);
    const double frame = static_cast<double>(schedule.fps.denominator) / static_cast<double>(schedule.fps.numerator);
    ClipKeys keys{{}, {}, false};
    for (std::size_t n = 0; n + 1 < steps.times.size(); ++n) {
        const float next = steps.times[n + 1];
        // At the end of a minute a float32 has only that resolution, so that the key before may be the one just below.
        const float before =
            std::min(static_cast<float>(static_cast<double>(next) - kChange * frame), std::nextafter(next, 0.0F));
        keys.times.insert(keys.times.end(), {steps.times[n], before});
        keys.pictures.insert(keys.pictures.end(), 2, steps.pictures[n]);
    }
    keys.times.push_back(steps.times.back());
    keys.pictures.push_back(0);
    return keys;
}

/// A schedule that changes on every frame has the times; the pictures are those on show.
ClipKeys per_frame(const Schedule& schedule) {
    Schedule ones = schedule;
    ones.pictures = schedule.frames;
    ones.holds.assign(static_cast<std::size_t>(schedule.frames), 1);
    ones.starts.clear();
    for (int frame = 0; frame < schedule.frames; ++frame) ones.starts.push_back(frame);
    ClipKeys keys = stepped(ones);
    for (std::size_t& picture : keys.pictures)
        picture = static_cast<std::size_t>(picture_at(schedule, static_cast<int>(picture)));
    return keys;
}

}  // namespace

ClipKeys clip_keys(const Schedule& schedule, Holding holding) {
    switch (holding) {
        case Holding::kHeld:
            return held(schedule);
        case Holding::kPerFrame:
            return per_frame(schedule);
        case Holding::kStep:
            break;
    }
    return stepped(schedule);
}

}  // namespace tuftwave::server::gltf
