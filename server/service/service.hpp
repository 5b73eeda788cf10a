#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>

#include "access/access.hpp"
#include "api/exchange.hpp"
#include "api/operation.hpp"
#include "api/routes.hpp"
#include "config/config.hpp"
#include "exec/pool.hpp"
#include "log/log.hpp"
#include "service/admission.hpp"
#include "service/computation.hpp"
#include "service/deadlines.hpp"
#include "service/metrics.hpp"

namespace tuftwave::server {

/// The whole service without a socket: every request that comes in has an answer that goes out. Thread-safe.
class Service {
  public:
    Service(const Config& config, Access& access, Pool& pool, Log& log);

    /// Looks at the head of a public request. What its body cannot change is answered at once: a wrong path or method,
    /// no key, a body over the limit, OPTIONS, no room for the work. @param is_whole  the body has come, too
    std::variant<Admission, Response> admit(const Request& head, bool is_whole);

    /// Answers /livez, /readyz and /metrics, at once whatever the load.
    Response handle_admin(const Request& request, const Traffic& traffic) const;

    /// What /livez and its like answer where they refuse; neither counted nor logged.
    static Response admin_problem(int status);

    /// Makes /readyz say that no new work is wanted; requests that still come are answered.
    void start_draining() { is_draining_ = true; }

    /// The answer where a request is refused before it is complete, by its framing or by the HTTP library.
    Response refuse(int status);

  private:
    using Clock = std::chrono::steady_clock;
    /// What the log and the metrics want to know of one request.
    struct Record {
        std::string route = "none";
        std::size_t bytes_in = 0;
        double queue_seconds = 0, core_seconds = 0, total_seconds = 0;
    };

    struct Order;

    void answer(const Route& route, const Visitor& visitor, Request request, std::stop_source stop, const Reply& reply);
    void compute(const Route& route, const Visitor& visitor, Request request, std::stop_source stop,
                 const Reply& reply);
    /// What needs no worker. @return  nothing if it was more than that
    std::optional<Response> answer_at_once(const Route& route, const Visitor& visitor, const Request& request,
                                           const Limits& limits);
    Answer run(const Route& route, const Request& request, const Context& context) const;
    /// Every answer goes through here, on its way out: it gets its number, is counted and logged.
    Response conclude(const Request& request, Answer made, const Record& record);
    Response conclude(const Order& order, Computation::Outcome outcome);
    std::string next_id();

    const Limits limits_, small_limits_;
    Access& access_;
    Pool& pool_;
    Log& log_;
    Metrics metrics_;
    Deadlines deadlines_;
    std::atomic<bool> is_draining_ = false;
    std::atomic<std::uint64_t> next_id_;
};

}  // namespace tuftwave::server
