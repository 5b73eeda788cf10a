#include "service/computation.hpp"

#include <utility>

namespace tuftwave::server {
namespace {

double seconds_between(const Computation::Clock::time_point from, const Computation::Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

}  // namespace

bool Computation::start() {
    const std::lock_guard lock(mutex_);
    if (state_ != State::kWaiting) return false;
    state_ = State::kRunning;
    started_ = Clock::now();
    return true;
}

void Computation::finish(Answer answer) {
    Outcome outcome;
    {
        const std::lock_guard lock(mutex_);
        state_ = State::kDone;
        outcome = {std::nullopt, seconds_between(created_, started_), seconds_between(started_, Clock::now()),
                   is_late_};
    }
    outcome.answer = std::move(answer);
    done_(std::move(outcome));
}

void Computation::expire() noexcept {
    {
        const std::lock_guard lock(mutex_);
        is_late_ = true;
        if (state_ == State::kDone) return;
        if (state_ == State::kRunning) {
            stop_.request_stop();
            return;
        }
        state_ = State::kDone;
    }
    stop_.request_stop();
    done_({std::nullopt, seconds_between(created_, Clock::now()), 0, true});
}

}  // namespace tuftwave::server
