#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "access/keys.hpp"
#include "access/origins.hpp"
#include "access/token_bucket.hpp"
#include "api/exchange.hpp"
#include "api/problem.hpp"
#include "config/config.hpp"

namespace tuftwave::server {

/// Whose request it is, as long as it is under way.
struct Visitor {
    std::optional<std::size_t> share;  ///< whose share pays for it; nothing where nobody does
    std::uint64_t paid_bytes = 0;      ///< of its body, by the deposit
};

/// Who may: keys, their shares, and pages elsewhere. Knows no socket. Thread-safe.
///
/// Without a key file nobody needs a key, and all together have one share. With one, everything needs a key but GET and
/// HEAD of the pages and their files, so that a page can load and ask for one, and OPTIONS, which browsers send bare.
class Access {
  public:
    /// Reads the key file and the origins of the configuration.
    static std::variant<std::unique_ptr<Access>, UsageError> open(const Config& config,
                                                                  Now now = std::chrono::steady_clock::now);

    /// @param keys  nothing: nobody needs one
    Access(const Config& config, std::optional<Keys> keys, Origins origins, Now now = std::chrono::steady_clock::now);
    Access(const Access&) = delete;
    Access& operator=(const Access&) = delete;

    /// Decides on the head alone. The same 401 whatever is wrong with a key; 429 says when to come again.
    std::variant<Visitor, Problem> admit(const Request& head);

    /// Takes what an admitted request has cost, once it is known.
    /// @param worker_seconds  measured: the time of all workers that it took
    /// @param body_bytes      that have come; those that were not announced (chunked) are paid for now
    void charge(const Visitor& visitor, double worker_seconds, std::uint64_t body_bytes = 0);

    /// The answer to a browser's preflight for a path that exists; nothing for any other request.
    std::optional<Response> preflight(const Request& head) const;

    /// Adds what a page elsewhere needs to read an answer; to be called for every answer, refusals included.
    void add_headers(const Request& request, Response& response) const { origins_.add_headers(request, response); }

    bool needs_keys() const { return keys_.has_value(); }

    /// What whoever starts the server should know; "" if there is nothing.
    const std::string& warning() const { return warning_; }

  private:
    const std::optional<Keys> keys_;
    const Origins origins_;
    std::deque<TokenBucket> shares_;  // one for each key, or one for all
    std::string warning_;
};

}  // namespace tuftwave::server
