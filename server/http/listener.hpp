#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "http/answerer.hpp"
#include "http/connection.hpp"

namespace tuftwave::server {

struct ListenerOptions {
    std::string host = "127.0.0.1";
    int port = 0;                                   ///< 0 picks a free one
    std::size_t connections = 64;                   ///< open at once; the next one gets 503
    std::size_t body_memory = 64 * 1024 * 1024;     ///< bytes of all bodies; the first 64 KiB of each are free
    std::size_t answer_memory = 192 * 1024 * 1024;  ///< bytes of all answers until they are taken; as above
    Patience patience{};
};

/// Speaks HTTP/1.1 on one port. One thread waits for all connections, so that thousands of slow ones cost memory and no
/// thread; each request is read completely, under deadlines, before anybody else sees it.
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
    ~Listener();
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    /// Takes the port. Fails if another process has it.
    /// @return  the port, or why not
    [[nodiscard]] std::variant<int, std::string> bind();

    /// Serves until stop(). Call it once, after bind().
    void serve();

    /// From now on every answer says "Connection: close", so that clients go elsewhere.
    void drain();

    /// Accepts no more. Requests that have begun are still answered, idle connections closed; then serve() returns.
    /// May be called at any time by any thread, also before serve().
    void stop();

    Stats stats() const;

  private:
    class Loop;
    std::unique_ptr<Loop> loop_;
};

}  // namespace tuftwave::server
