#pragma once

#include <sys/resource.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace tuftwave::bench {

using Milliseconds = std::chrono::duration<double, std::milli>;

/// Calls of a measurement: enough of them to be warm, then what fits into a moment. Every program is run once per
/// round, so a round of all of them must be short.
constexpr Milliseconds kWarming{100}, kMeasuring{300};
constexpr std::size_t kFewestCalls = 3, kMostCalls = 500;

/// How long one call takes.
template <class Work>
double time_of(Work&& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return Milliseconds(std::chrono::steady_clock::now() - begin).count();
}

/// Keeps the compiler from leaving out what nobody looks at.
template <class Value>
void keep(const Value& value) {
    asm volatile("" : : "r"(&value) : "memory");
}

/// Bytes that this process has held at most.
inline double peak_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// One line that tests/bench/bench.py reads.
inline void print_samples(const std::string& name, const std::vector<double>& ms) {
    std::printf("{\"name\": \"%s\", \"ms\": [", name.c_str());
    for (std::size_t i = 0; i < ms.size(); ++i) std::printf("%s%.6g", i == 0 ? "" : ", ", ms[i]);
    std::puts("]}");
}

inline void print_value(const std::string& name, double value, const char* unit) {
    std::printf("{\"name\": \"%s\", \"value\": [%.10g], \"unit\": \"%s\"}\n", name.c_str(), value, unit);
}

/// Prints the times of warm calls.
template <class Work>
void measure(const std::string& name, Work&& work) {
    for (double spent = 0; spent < kWarming.count();) spent += time_of(work);
    std::vector<double> ms;
    for (double spent = 0; ms.size() < kFewestCalls || (spent < kMeasuring.count() && ms.size() < kMostCalls);) {
        ms.push_back(time_of(work));
        spent += ms.back();
    }
    print_samples(name, ms);
}

}  // namespace tuftwave::bench
