#pragma once

#include <cstdint>
#include <vector>

#include "tuftwave/limits.hpp"
#include "tuftwave/result.hpp"

namespace tuftwave {

/// Which reading of the papers is used: mended as core/README.md says, or as they were printed.
enum class Formulas { kCorrected, kAsPrinted };

/// Where the shorter holds of a cycle go: to its last pictures (the paper), or spread evenly.
enum class ShortHolds { kLast, kSpread };

/// When a picture's phase is taken: evenly over the cycle (the paper), or at the frame where the picture starts.
enum class Sampling { kUniform, kByFrame };

/// Frames per second as a fraction: 24000/1001 is not a double.
struct FrameRate {
    std::int64_t numerator = 24;
    std::int64_t denominator = 1;

    double value() const { return static_cast<double>(numerator) / static_cast<double>(denominator); }
    friend bool operator==(const FrameRate&, const FrameRate&) = default;
};

/// The frame rate nearest to `fps`, exact to a millionth of a frame per second.
FrameRate to_frame_rate(double fps);

/// How a cycle is cut into pictures.
struct Timing {
    double period = 0.45;  ///< T, seconds
    FrameRate fps;
    int hold = 2;  ///< N_dup, frames a picture is normally held: 1 "on ones", 2 "on twos", 3 "on threes"
    ShortHolds short_holds = ShortHolds::kLast;
    Sampling sampling = Sampling::kUniform;
};

/// The exposure sheet of one cycle.
struct Schedule {
    int frames = 0;           ///< N_frame
    int pictures = 0;         ///< N_pict, the length of `holds` and `starts`
    std::vector<int> holds;   ///< frames picture n is shown; they sum to `frames`
    std::vector<int> starts;  ///< first frame of picture n, from 0
    FrameRate fps;
    double requested_period = 0;  ///< T, seconds
    double period = 0;            ///< frames / fps, seconds: what is really produced
    Sampling sampling = Sampling::kUniform;
};

/// Cuts a cycle into pictures and holds.
/// @return  holds of 1..timing.hold frames that sum to floor(fps T + 0.5 + 1e-9)
/// @errors  not_finite, out_of_range, too_few (less than half a frame), too_many (pictures, frames),
/// undefined_as_printed (K > N_pict with kAsPrinted) Source: Furukawa and Nakata 2018, section 2; holds by divmod, see
/// core/README.md.
Result<Schedule> make_schedule(const Timing& timing, Formulas formulas, const Limits& limits);

/// Whether a sheet of `repeat` cycles is short enough.
/// @errors  out_of_range, too_many (frames), both at "/repeat"
Check check_repeat(const Schedule& schedule, int repeat, const Limits& limits);

/// The picture on show at `frame`, counted from the start of any cycle. @param frame  >= 0
int picture_at(const Schedule& schedule, int frame);

/// The phase of `picture`, radians in [0, 2 pi), from integers only, so that a whole cycle later it is the same number.
/// @param cycles  waves that pass during one loop, >= 1
/// @param shift   how far to run ahead, in steps of 2 pi / pictures, any sign
double picture_phase(const Schedule& schedule, int picture, int cycles = 1, int shift = 0);

/// Whether `pictures` is in the range of 3 to 8 that animators use; outside it a caller should be told.
inline bool is_usual_picture_count(int pictures) { return pictures >= 3 && pictures <= 8; }

}  // namespace tuftwave
