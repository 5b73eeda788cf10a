#pragma once

#include <chrono>
#include <cstdint>
#include <functional>

#include "http/sockets.hpp"

namespace tuftwave::server {

/// What a socket waits for.
struct Interest {
    bool to_read = false, to_write = false;
    bool to_see_end = false;  ///< of what the peer sends

    friend bool operator==(const Interest&, const Interest&) = default;
};

/// What happened to it.
struct Event {
    std::uint64_t id = 0;
    bool can_read = false, can_write = false;
    bool has_peer_closed = false;  ///< its sending side, at least
    bool is_broken = false;
};

/// Waits for many sockets at once (epoll, level-triggered), and for whoever wakes it.
class Poller {
  public:
    /// @throws std::system_error  if the system has no descriptors left
    Poller();

    /// @return  false if the system refuses
    [[nodiscard]] bool add(int socket, std::uint64_t id, Interest interest);
    void change(int socket, std::uint64_t id, Interest interest);

    /// Waits for at most `patience`, or until woken, and tells of everything that happened.
    void wait(std::chrono::milliseconds patience, const std::function<void(const Event&)>& tell);

    /// Ends a wait(), now or the next one. By any thread, also in a signal handler.
    void wake();

  private:
    Descriptor epoll_, wake_;
};

}  // namespace tuftwave::server
