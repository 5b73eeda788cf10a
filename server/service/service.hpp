#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

#include "api/exchange.hpp"
#include "api/operation.hpp"
#include "api/routes.hpp"
#include "config/config.hpp"
#include "exec/pool.hpp"
#include "log/log.hpp"
#include "service/metrics.hpp"

namespace tuftwave::server {

/// The whole service without a socket: every request that comes in has an answer that goes out. Thread-safe.
class Service {
  public:
    Service(const Config& config, Pool& pool, Log& log);

    /// Answers a public request. Computations wait for a worker at most until the deadline; a full queue is 503.
    Response handle(const Request& request);

    /// Answers /livez, /readyz and /metrics, at once whatever the load.
    Response handle_admin(const Request& request) const;

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
        double queue_seconds = 0, core_seconds = 0;
    };

    Answer answer(const Request& request, Record& record);
    Answer compute(const Route& route, const Request& request, Record& record);
    Answer run(const Route& route, const Request& request, std::stop_token stop, const ForEach& for_each) const;
    std::string next_id();
    void note(const Request& request, const Response& response, const std::string& id, const Record& record,
              double seconds);

    const Limits limits_;
    const std::chrono::duration<double> deadline_;
    Pool& pool_;
    Log& log_;
    Metrics metrics_;
    std::atomic<bool> is_draining_ = false;
    std::atomic<std::uint64_t> next_id_;
};

}  // namespace tuftwave::server
