#include "access/token_bucket.hpp"

#include <algorithm>
#include <utility>

namespace tuftwave::server {

TokenBucket::TokenBucket(const double rate, const double burst, Now now)
    : rate_(rate), burst_(burst), now_(std::move(now)), balance_(burst), filled_(now_()) {}

std::optional<double> TokenBucket::admit(const double deposit) {
    if (rate_ <= 0) return {};
    const std::lock_guard lock(mutex_);
    fill();
    if (balance_ <= 0) return -balance_ / rate_;
    balance_ -= deposit;
    return {};
}

void TokenBucket::charge(const double units) {
    if (rate_ <= 0) return;
    const std::lock_guard lock(mutex_);
    fill();  // before it is taken, or a full bucket would let time pass that it could not keep
    balance_ -= units;
}

void TokenBucket::fill() {
    const auto now = now_();
    if (now <= filled_) return;
    balance_ = std::min(burst_, balance_ + rate_ * std::chrono::duration<double>(now - filled_).count());
    filled_ = now;
}

}  // namespace tuftwave::server
