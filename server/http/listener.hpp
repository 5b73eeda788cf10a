#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "api/exchange.hpp"

namespace tuftwave::server {

struct ListenerOptions {
    std::string host = "127.0.0.1";
    int port = 0;          ///< 0 picks a free one
    int connections = 64;  ///< threads, one for each open connection
    /// The most bytes of the body of a request for a path.
    std::function<std::size_t(const std::string& path)> body_limit = [](const std::string&) { return 1024 * 1024; };
};

/// Speaks HTTP/1.1 on one port and hands complete requests on. Every answer of its own (bad framing, a body over the
/// limit, too slow, an exception) is made by `problem`, so that clients see one kind of error.
class Listener {
  public:
    using Handle = std::function<Response(const Request&)>;
    using Problem = std::function<Response(int status)>;

    /// @param handle   called by several threads at once, for every method (also HEAD, whose body is then left out) and
    ///                 every path. If it throws, the client gets problem(500).
    /// @param problem  the body for a status of 400 and above
    Listener(ListenerOptions options, Handle handle, Problem problem);
    /// Stop it and let serve() return before.
    ~Listener();
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    /// Takes the port. Fails if another process has it.
    /// @return  the port, or why not
    [[nodiscard]] std::variant<int, std::string> bind();

    /// Serves until stop(). Call it once, after bind().
    /// @return  false if it ended without stop()
    [[nodiscard]] bool serve();

    /// From now on every answer says "Connection: close", so that clients go elsewhere.
    void drain();

    /// Accepts no more. Requests that have arrived are still answered, idle connections closed; then serve() returns.
    /// May be called at any time by any thread, also before serve().
    void stop();

  private:
    class Server;
    std::unique_ptr<Server> server_;
};

}  // namespace tuftwave::server
