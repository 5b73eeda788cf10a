#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <ostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tuftwave/for_each.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/result.hpp"
#include "tuftwave/tuft.hpp"

namespace tuftwave {

/// GoogleTest prints a code by its number; a name is kinder.
inline void PrintTo(const ErrorCode code, std::ostream* out) {
    constexpr const char* kNames[] = {"not_finite", "out_of_range",         "too_few",  "too_many", "degenerate",
                                      "conflict",   "undefined_as_printed", "cancelled"};
    *out << kNames[static_cast<std::size_t>(code)];
}

}  // namespace tuftwave

namespace tuftwave::test {

/// Numbers from raw bits: standard distributions differ between libraries.
class Random {
  public:
    explicit Random(const std::uint64_t seed) : engine_(seed) {}
    double between(const double low, const double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    int below(const int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
    Vec3 in_cube(const double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
    Vec3 direction() {
        for (;;) {
            const Vec3 v = in_cube(1);
            if (dot(v, v) > 0.01 && dot(v, v) < 1) return normalized(v);
        }
    }
    Quat rotation() { return turn_about(direction(), between(-kPi, kPi)); }

  private:
    std::mt19937_64 engine_;
};

/// Whether a check refused with this code and field; says what it did instead.
inline testing::AssertionResult is_refused(const Check& check, const ErrorCode code, const std::string& field) {
    if (!check) return testing::AssertionFailure() << "was accepted";
    if (check->code == code && check->field == field) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "was refused with " << testing::PrintToString(check->code) << " at \""
                                       << check->field << "\"";
}

template <class T>
testing::AssertionResult is_refused(const Result<T>& result, const ErrorCode code, const std::string& field) {
    return is_refused(result ? Check{} : Check{result.error()}, code, field);
}

/// Whether two points are nearer than `tolerance`.
inline testing::AssertionResult are_near(const Vec3& a, const Vec3& b, const double tolerance) {
    const double apart = length(a - b);
    if (apart <= tolerance) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "(" << a.x << ", " << a.y << ", " << a.z << ") and (" << b.x << ", " << b.y
                                       << ", " << b.z << ") are " << apart << " apart";
}

/// Whether two lists of points agree; names the first that does not.
inline testing::AssertionResult are_near(const std::vector<Vec3>& a, const std::vector<Vec3>& b,
                                         const double tolerance) {
    if (a.size() != b.size()) return testing::AssertionFailure() << a.size() << " and " << b.size() << " points";
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (testing::AssertionResult near = are_near(a[i], b[i], tolerance); !near) return near << " at index " << i;
    }
    return testing::AssertionSuccess();
}

/// From the last index to the first, as a pool of threads may well do.
class LastFirst final : public ForEach {
  public:
    void operator()(const std::size_t count, const std::function<void(std::size_t)>& job) const override {
        for (std::size_t i = count; i > 0; --i) job(i - 1);
    }
};

/// First the even indices, then the odd ones.
class EvenFirst final : public ForEach {
  public:
    void operator()(const std::size_t count, const std::function<void(std::size_t)>& job) const override {
        for (std::size_t i = 0; i < count; i += 2) job(i);
        for (std::size_t i = 1; i < count; i += 2) job(i);
    }
};

}  // namespace tuftwave::test
