#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>

#include "api/operation.hpp"
#include "service/deadlines.hpp"

namespace tuftwave::server {

/// A computation between its acceptance and its answer. A worker starts and finishes it; its deadline may come first,
/// and asks the work to stop. It is answered once, whoever comes first.
class Computation final : public Expiring {
  public:
    using Clock = std::chrono::steady_clock;
    /// How it ended. Nothing when it never got a worker.
    struct Outcome {
        std::optional<Answer> answer;
        double queue_seconds = 0, core_seconds = 0;
        bool is_late = false;  ///< its deadline passed before
    };

    /// @param stop  asked to stop when the deadline passes
    /// @param done  called once, by the worker or the deadline's thread; must not throw
    Computation(std::stop_source stop, std::function<void(Outcome)> done)
        : stop_(std::move(stop)), done_(std::move(done)) {}

    /// For a worker: @return  whether the work should still be done
    bool start();
    /// What start() allowed has ended.
    void finish(Answer answer);
    void expire() noexcept override;

    std::stop_token stop_token() const { return stop_.get_token(); }

  private:
    enum class State { kWaiting, kRunning, kDone };

    std::mutex mutex_;
    State state_ = State::kWaiting;
    bool is_late_ = false;
    const Clock::time_point created_ = Clock::now();
    Clock::time_point started_;
    std::stop_source stop_;
    const std::function<void(Outcome)> done_;
};

}  // namespace tuftwave::server
