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
    entry_.push_back({Clock::now() + deadlines.patience_, &who});
    position_ = entry_.begin();
    const std::lock_guard lock(deadlines_.mutex_);
    const bool was_empty = deadlines_.waiting_.empty();
    deadlines_.waiting_.splice(deadlines_.waiting_.end(), entry_);
    if (was_empty) deadlines_.wake_.notify_all();
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
        if (waiting_.empty()) {
            wake_.wait(lock);
        } else if (const auto first = waiting_.front().time; Clock::now() < first) {
            wake_.wait_until(lock, first);
        } else {
            Expiring* const who = std::exchange(waiting_.front().who, nullptr);
            expired_.splice(expired_.end(), waiting_, waiting_.begin());
            who->expire();  // the mutex keeps it alive
        }
    }
}

}  // namespace tuftwave::server
