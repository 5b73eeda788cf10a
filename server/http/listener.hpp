#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "http/event_loop.hpp"
#include "http/poller.hpp"
#include "http/premises.hpp"
#include "http/sockets.hpp"

namespace tuftwave::server {

/// Speaks HTTP/1.1 on one port. The thread that serves lets connections in; each is then served by one of a few other
/// threads, in turns, so that small requests are answered on as many cores.
class Listener {
  public:
    struct Stats {
        std::size_t connections = 0;                   ///< open now
        std::uint64_t accepted = 0;                    ///< since the start
        std::uint64_t turned_away = 0;                 ///< of these, since there were too many
        std::size_t body_bytes = 0, answer_bytes = 0;  ///< held now
    };

    Listener(ListenerOptions options, Answerer answerer);
    /// Stop it and let serve() return before.
    ~Listener() = default;
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    /// Takes the port. Fails if another process has it.
    /// @return  the port, or why not
    [[nodiscard]] std::variant<int, std::string> bind();

    /// Serves until stop(). Call it once, after bind().
    void serve();

    /// From now on every answer says "Connection: close", so that clients go elsewhere.
    void drain() { *premises_.draining = true; }

    /// Accepts no more. Requests that have begun are still answered, idle connections closed; then serve() returns.
    /// May be called at any time by any thread, also before serve().
    void stop();

    Stats stats() const;

  private:
    void let_in();
    bool accept_one();
    void place(Descriptor socket);

    Premises premises_;
    std::vector<std::unique_ptr<EventLoop>> loops_;
    std::size_t next_loop_ = 0;
    Poller poller_;
    Descriptor door_;
    std::atomic<bool> stopping_ = false;
    std::atomic<std::uint64_t> accepted_ = 0, turned_away_ = 0;
};

}  // namespace tuftwave::server
