#pragma once

#include <atomic>
#include <cstdint>
#include <list>
#include <memory>
#include <string>

#include "api/exchange.hpp"
#include "http/library.hpp"
#include "http/mailbox.hpp"

namespace tuftwave::server {

/// The answer that somebody owes to a connection. If it is never paid, the connection is closed.
class Debt {
  public:
    /// @param draining  whether the listener wants its clients to go elsewhere; outlives this
    Debt(std::shared_ptr<Mailbox> mailbox, std::shared_ptr<const Library> library,
         std::shared_ptr<const std::atomic<bool>> draining, std::uint64_t connection, std::string method, bool closes);
    ~Debt();
    Debt(const Debt&) = delete;
    Debt& operator=(const Debt&) = delete;

    /// Words the answer on the caller's thread and posts it. Only the first one counts. Never throws.
    void pay(Response answer) noexcept;

  private:
    const std::shared_ptr<Mailbox> mailbox_;
    const std::shared_ptr<const Library> library_;
    const std::shared_ptr<const std::atomic<bool>> draining_;
    const std::string method_;
    std::list<Letter> letter_;  // one, until it is posted
};

}  // namespace tuftwave::server
