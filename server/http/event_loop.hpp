#pragma once

#include <memory>

#include "http/premises.hpp"
#include "http/sockets.hpp"

namespace tuftwave::server {

/// Serves connections on one thread, which waits for all of them, so that thousands of slow ones cost memory and no
/// thread; each request is read completely, under deadlines, before anybody else sees it.
class EventLoop {
  public:
    /// @param premises  outlive it
    /// @throws std::system_error  if the system has no descriptors left
    explicit EventLoop(Premises& premises);
    /// Let serve() return before.
    ~EventLoop();
    EventLoop(const EventLoop&) = delete;
    EventLoop& operator=(const EventLoop&) = delete;

    /// Serves one connection more. By any thread, before finish().
    /// @param socket           does not block
    /// @param is_one_too_many  all that it gets is 503
    void take_in(Descriptor socket, bool is_one_too_many);

    /// Nobody is taken in any more: requests that have begun are still answered, idle connections closed; then serve()
    /// returns. By any thread.
    void finish();

    /// Serves until finish(). Call it once.
    void serve();

  private:
    class Connections;
    std::unique_ptr<Connections> connections_;
};

}  // namespace tuftwave::server
