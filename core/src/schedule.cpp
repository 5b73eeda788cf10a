// Based on: K. Furukawa, S. Nakata. Automatic Generation of the Periodic Hair Motion of 3D Characters for Anime
// Production. ICEC 2018. Section 2, discretisation in time.
// Differs: holds by divmod. That equals the paper's rule wherever the paper's is defined, and also works where
// K = N_dup N_pict - N_frame exceeds N_pict.
#include "tuftwave/schedule.hpp"

#include <numeric>

#include "tuftwave/math.hpp"

namespace tuftwave {
namespace {

/// Lifts a product such as 25 x 0.58 = 14.499999999999998 over the tie it stands for; far below any real timing.
constexpr double kTieTolerance = 1e-9;

Check check_timing(const Timing& timing, const Limits& limits) {
    if (Check wrong = check_range(timing.period, limits.period, "/period")) return wrong;
    if (timing.fps.numerator < 1 || timing.fps.denominator < 1)
        return Error{ErrorCode::kOutOfRange,
                     "/fps",
                     std::to_string(timing.fps.numerator) + "/" + std::to_string(timing.fps.denominator),
                     "1 to 240",
                     limits.fps.minimum,
                     limits.fps.maximum};
    if (Check wrong = check_range(timing.fps.value(), limits.fps, "/fps")) return wrong;
    return check_range(timing.hold, limits.hold, "/hold");
}

Check check_frames(int frames, int pictures, const Timing& timing, Formulas formulas, const Limits& limits) {
    const auto per_cycle = [&](int count, std::size_t maximum, ErrorCode code, const std::string& what) {
        return Error{
            code,
            "/period",
            timing.period,
            what + " per cycle from 1 to " + std::to_string(maximum) + "; these settings give " + std::to_string(count),
            {},
            {}};
    };
    if (frames < 1) return per_cycle(frames, limits.frames, ErrorCode::kTooFew, "frames");
    if (frames > static_cast<int>(limits.frames))
        return per_cycle(frames, limits.frames, ErrorCode::kTooMany, "frames");
    if (pictures > static_cast<int>(limits.pictures))
        return per_cycle(pictures, limits.pictures, ErrorCode::kTooMany, "pictures");
    const int short_pictures = timing.hold * pictures - frames;  // K
    if (formulas == Formulas::kAsPrinted && short_pictures > pictures)
        return Error{ErrorCode::kUndefinedAsPrinted,
                     "/hold",
                     static_cast<double>(timing.hold),
                     "as printed, at most as many short pictures as pictures; these settings give " +
                         std::to_string(short_pictures) + " of " + std::to_string(pictures),
                     {},
                     {}};
    return {};
}

/// Sets starts and holds of a schedule whose frames and pictures are known.
void fill_holds(Schedule& schedule, ShortHolds short_holds) {
    const int n_frame = schedule.frames, n_pict = schedule.pictures;
    const int q = n_frame / n_pict, r = n_frame % n_pict;
    const auto start = [&](int n) {
        return short_holds == ShortHolds::kLast ? n * q + (n < r ? n : r) : n * n_frame / n_pict;
    };
    for (int n = 0; n < n_pict; ++n) {
        schedule.starts.push_back(start(n));
        schedule.holds.push_back(start(n + 1) - start(n));
    }
}

std::int64_t wrapped(std::int64_t value, std::int64_t modulus) {
    const std::int64_t rest = value % modulus;
    return rest < 0 ? rest + modulus : rest;
}

}  // namespace

FrameRate to_frame_rate(double fps) {
    constexpr std::int64_t kMillion = 1'000'000;
    if (!(fps > 0 && fps < 1e9)) return {0, 1};
    const auto millionths = static_cast<std::int64_t>(fps * kMillion + 0.5);
    const std::int64_t divisor = std::gcd(millionths, kMillion);
    return divisor == 0 ? FrameRate{0, 1} : FrameRate{millionths / divisor, kMillion / divisor};
}

Result<Schedule> make_schedule(const Timing& timing, Formulas formulas, const Limits& limits) {
    if (Check wrong = check_timing(timing, limits)) return *wrong;
    const double exact = timing.fps.value() * timing.period;
    const auto frames = static_cast<int>(exact + 0.5 + kTieTolerance);  // at most 240 x 60
    const int pictures = (frames + timing.hold - 1) / timing.hold;
    if (Check wrong = check_frames(frames, pictures, timing, formulas, limits)) return *wrong;

    Schedule schedule;
    schedule.frames = frames;
    schedule.pictures = pictures;
    schedule.fps = timing.fps;
    schedule.requested_period = timing.period;
    schedule.period = frames / timing.fps.value();
    schedule.sampling = timing.sampling;
    fill_holds(schedule, timing.short_holds);
    return schedule;
}

Check check_repeat(const Schedule& schedule, int repeat, const Limits& limits) {
    if (Check wrong = check_range(repeat, limits.repeat, "/repeat")) return wrong;
    const auto frames = static_cast<std::size_t>(schedule.frames) * static_cast<std::size_t>(repeat);
    if (frames <= limits.sheet_frames) return {};
    return Error{ErrorCode::kTooMany,
                 "/repeat",
                 static_cast<double>(repeat),
                 "sheets of at most " + std::to_string(limits.sheet_frames) + " frames; these settings give " +
                     std::to_string(frames),
                 {},
                 {}};
}

int picture_at(const Schedule& schedule, int frame) {
    const int in_cycle = frame % schedule.frames;
    int picture = 0;
    while (picture + 1 < schedule.pictures && schedule.starts[static_cast<std::size_t>(picture) + 1] <= in_cycle)
        ++picture;
    return picture;
}

double picture_phase(const Schedule& schedule, int picture, int cycles, int shift) {
    const std::int64_t frames = schedule.frames, pictures = schedule.pictures;
    std::int64_t part = std::int64_t{cycles} * picture + shift, whole = pictures;
    if (schedule.sampling == Sampling::kByFrame && cycles == 1) {  // the shift goes to another of the same drawings
        part = schedule.starts[static_cast<std::size_t>(wrapped(std::int64_t{picture} + shift, pictures))];
        whole = frames;
    } else if (schedule.sampling == Sampling::kByFrame) {
        part =
            cycles * schedule.starts[static_cast<std::size_t>(wrapped(picture, pictures))] * pictures + shift * frames;
        whole = frames * pictures;
    }
    return 2 * kPi * static_cast<double>(wrapped(part, whole)) / static_cast<double>(whole);
}

}  // namespace tuftwave
