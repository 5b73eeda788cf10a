#include "service/deadlines.hpp"

#include <utility>

namespace tuftwave::server {

using Clock = std::chrono::steady_clock;

Deadlines::Deadlines(const std::chrono::duration<double> patience)
    : patience_(std::chrono::duration_cast<Clock::duration>(patience)), thread_([this] { run(); }) {}

Deadlines::~Deadlines() {
    {
        std::unique_lock lock(mutex_);
        all_gone_.wait(lock, [&] { return waiting_.empty() && expired_.empty(); });
        stopping_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

Deadlines::Watch::Watch(Deadlines& deadlines, Expiring& who) : deadlines_(deadlines) {
    entry_.push_back({{}, &who});
    position_ = entry_.begin();
    const std::lock_guard lock(deadlines_.mutex_);
    position_->time = Clock::now() + deadlines_.patience_;
    deadlines_.waiting_.splice(deadlines_.waiting_.end(), entry_);
}

Deadlines::Watch::~Watch() {
    const std::lock_guard lock(deadlines_.mutex_);
    std::list<Entry>& list = position_->who ? deadlines_.waiting_ : deadlines_.expired_;
    entry_.splice(entry_.end(), list, position_);
    deadlines_.all_gone_.notify_all();
}

void Deadlines::run() {
    std::unique_lock lock(mutex_);
    while (!stopping_) {
        // Never for longer than all wait: who comes meanwhile is told in time, and nobody needs to wake this thread.
        const auto next = waiting_.empty() ? Clock::now() + patience_ : waiting_.front().time;
        if (Clock::now() < next) {
            wake_.wait_until(lock, next);
        } else {
            Expiring* const who = std::exchange(waiting_.front().who, nullptr);
            expired_.splice(expired_.end(), waiting_, waiting_.begin());
            who->expire();  // the mutex keeps it alive
        }
    }
}

}  // namespace tuftwave::server
