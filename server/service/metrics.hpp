#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <tuple>

namespace tuftwave::server {

/// The public listener as the metrics show it.
struct Traffic {
    std::uint64_t connections = 0;                   ///< open now
    std::uint64_t accepted = 0, turned_away = 0;     ///< since the start
    std::uint64_t body_bytes = 0, answer_bytes = 0;  ///< held now
};

/// Everything that the metrics do not count by themselves.
struct Gauges {
    std::uint64_t workers = 0, busy = 0, queued = 0, capacity = 0;
    double saturation = 0;
    std::uint64_t dropped_log_lines = 0;
    Traffic traffic;
};

/// Counters of the service in Prometheus' text form. Thread-safe.
class Metrics {
  public:
    /// One answered request. @param route  the route's template, or "none"
    void count_request(const std::string& route, const std::string& method, int status, double seconds,
                       std::size_t bytes_out);

    /// Time that an accepted computation waited for a worker.
    void count_queue_wait(double seconds);

    /// A request that is being answered, for as long as this lives.
    class InFlight {
      public:
        explicit InFlight(Metrics& metrics) : count_(metrics.in_flight_) { ++count_; }
        ~InFlight() { --count_; }
        InFlight(const InFlight&) = delete;
        InFlight& operator=(const InFlight&) = delete;

      private:
        std::atomic<std::uint64_t>& count_;
    };

    /// Prometheus text format 0.0.4.
    std::string text(const Gauges& gauges) const;

  private:
    /// Upper bounds of the duration buckets, seconds.
    static constexpr std::array<double, 11> kBounds{0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 1, 2.5, 10};
    struct Histogram {
        std::array<std::uint64_t, kBounds.size() + 1> buckets{};
        double sum = 0;

        void add(double seconds);
        void write(std::string& out, const std::string& name, const std::string& labels) const;
    };

    mutable std::mutex mutex_;
    std::map<std::tuple<std::string, std::string, int>, std::uint64_t> requests_;  // route, method, status
    std::map<std::string, Histogram> durations_;                                   // route
    Histogram queue_wait_;
    std::uint64_t bytes_out_ = 0;
    std::atomic<std::uint64_t> in_flight_ = 0;
};

}  // namespace tuftwave::server
