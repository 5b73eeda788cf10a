#pragma once

#include <cstdint>
#include <list>
#include <mutex>
#include <utility>

#include "http/library.hpp"
#include "http/poller.hpp"
#include "http/sockets.hpp"

namespace tuftwave::server {

/// An answer on its way to the thread of its connection. Without a head there is none, and the connection can only be
/// closed. Or a connection that is new there.
struct Letter {
    std::uint64_t connection = 0;
    Message message;
    bool closes = true;
    Descriptor newcomer{};  ///< if it is open, there is no message
};

/// Where any thread posts letters, and one thread collects them. Posting allocates nothing, so no answer is lost for
/// want of memory; it wakes the collector only if that sleeps, since a wake-up costs more than many an answer.
class Mailbox {
  public:
    explicit Mailbox(Poller& poller) : poller_(&poller) {}

    /// @param letter  one; left empty
    void post(std::list<Letter>& letter) {
        const std::lock_guard lock(mutex_);
        letters_.splice(letters_.end(), letter);
        if (std::exchange(is_asleep_, false) && poller_) poller_->wake();
    }

    /// For the collector, before it waits. @return  false if it must not, since there are letters
    bool may_sleep() {
        const std::lock_guard lock(mutex_);
        return is_asleep_ = letters_.empty();
    }

    /// And when it has waited: it will look here before it does so again.
    void stay_awake() {
        const std::lock_guard lock(mutex_);
        is_asleep_ = false;
    }

    std::list<Letter> collect() {
        const std::lock_guard lock(mutex_);
        return std::exchange(letters_, {});
    }

    /// Nobody will collect any more.
    void close() {
        const std::lock_guard lock(mutex_);
        poller_ = nullptr;
    }

  private:
    std::mutex mutex_;
    std::list<Letter> letters_;
    Poller* poller_;
    bool is_asleep_ = false;
};

}  // namespace tuftwave::server
