#include "service/service.hpp"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <new>
#include <optional>

namespace tuftwave::server {
namespace {

double seconds_between(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

Problem busy() { return {ProblemCode::kBusy, "", {}, {{"Retry-After", "1"}}}; }

/// A client's method as a metrics label: one of a few words, whatever was sent.
std::string method_label(const std::string& method) {
    for (const char* const known : {"GET", "HEAD", "POST", "OPTIONS"}) {
        if (method == known) return method;
    }
    return "other";
}

Response plain(int status, std::string text) {
    return {status, "text/plain; charset=utf-8", std::move(text), {{"Cache-Control", "no-store"}}};
}

/// The problem behind a bare HTTP status.
Problem http_problem(int status) {
    constexpr ProblemCode kCodes[] = {ProblemCode::kNotFound,
                                      ProblemCode::kMethodNotAllowed,
                                      ProblemCode::kTooSlow,
                                      ProblemCode::kLengthRequired,
                                      ProblemCode::kTooLarge,
                                      ProblemCode::kUriTooLong,
                                      ProblemCode::kUnsupportedMediaType,
                                      ProblemCode::kHeadersTooLarge,
                                      ProblemCode::kBusy};
    for (const ProblemCode code : kCodes) {
        if (server::status(code) == status) return {code, "", {}, {}};
    }
    return {status >= 500 ? ProblemCode::kInternal : ProblemCode::kBadRequest, "", {}, {}};
}

/// A computation handed from a connection's thread to a worker. Whoever comes second finds out: a worker that starts
/// an abandoned ticket does nothing, a connection that gives up on a started one waits until it has stopped.
class Ticket {
  public:
    /// @return  whether the work should still be done
    bool start() {
        const std::lock_guard lock(mutex_);
        if (state_ == State::kAbandoned) return false;
        state_ = State::kRunning;
        started_ = std::chrono::steady_clock::now();
        return true;
    }

    void finish(Answer answer) {
        const std::lock_guard lock(mutex_);
        answer_ = std::move(answer);
        done_.notify_all();
    }

    /// Waits for the answer; past the deadline asks the work to stop. Nothing when it never started.
    std::optional<Answer> wait(std::chrono::duration<double> deadline) {
        std::unique_lock lock(mutex_);
        const auto is_done = [&] { return answer_.has_value(); };
        if (!done_.wait_for(lock, deadline, is_done)) {
            stop_.request_stop();
            if (state_ == State::kWaiting) {
                state_ = State::kAbandoned;
                return {};
            }
            done_.wait(lock, is_done);
        }
        return std::move(answer_);
    }

    std::stop_token stop_token() const { return stop_.get_token(); }
    std::chrono::steady_clock::time_point started() const { return started_; }

  private:
    enum class State { kWaiting, kRunning, kAbandoned };

    std::mutex mutex_;
    std::condition_variable done_;
    State state_ = State::kWaiting;
    std::chrono::steady_clock::time_point started_;
    std::optional<Answer> answer_;
    std::stop_source stop_;
};

}  // namespace

Service::Service(const Config& config, Pool& pool, Log& log)
    : deadline_(config.deadline_seconds),
      pool_(pool),
      log_(log),
      next_id_(static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count())) {}

Response Service::handle(const Request& request) {
    const auto begin = Clock::now();
    const Metrics::InFlight in_flight(metrics_);
    Record record;
    const std::string id = next_id();
    Answer made = answer(request, record);
    Response response = std::holds_alternative<Problem>(made) ? to_response(std::get<Problem>(made), id)
                                                              : std::get<Response>(std::move(made));
    response.headers.emplace_back("Request-Id", id);
    note(request, response, id, record, seconds_between(begin, Clock::now()));
    return response;
}

Answer Service::answer(const Request& request, Record& record) {
    if (request.method == "OPTIONS") {
        if (const std::string allowed = allowed_methods(request.path); !allowed.empty())
            return Response{204, "", "", {{"Allow", allowed}}};
    }
    const auto found = find_route(request.method, request.path);
    if (const auto* problem = std::get_if<Problem>(&found)) return *problem;
    const Route& route = *std::get<const Route*>(found);
    record.route = route.path;
    if (route.computes) return compute(route, request, record);
    const auto begin = Clock::now();
    Answer made = run(route, request, {}, InOrder());
    record.core_seconds = seconds_between(begin, Clock::now());
    return made;
}

Answer Service::compute(const Route& route, const Request& request, Record& record) {
    const auto ticket = std::make_shared<Ticket>();
    const auto begin = Clock::now();
    const bool accepted = pool_.submit([this, ticket, &route, &request] {
        if (ticket->start()) ticket->finish(run(route, request, ticket->stop_token(), pool_.for_each()));
    });
    if (!accepted) return busy();
    std::optional<Answer> made = ticket->wait(deadline_);
    if (!made) return busy();  // it never got a worker in time
    record.queue_seconds = seconds_between(begin, ticket->started());
    record.core_seconds = seconds_between(ticket->started(), Clock::now());
    metrics_.count_queue_wait(record.queue_seconds);
    return *std::move(made);
}

Answer Service::run(const Route& route, const Request& request, std::stop_token stop, const ForEach& for_each) const {
    try {
        Answer made = route.run(request, {limits_, for_each, stop});
        if (stop.stop_requested()) return Problem{ProblemCode::kDeadline, "", {}, {}};
        return made;
    } catch (const std::bad_alloc&) {
        return busy();
    } catch (...) {  // what it says is for us, never for a client
        log_.event(Log::Level::kError, "an operation threw", {{"route", std::string(route.path)}});
        return Problem{ProblemCode::kInternal, "", {}, {}};
    }
}

std::string Service::next_id() {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::uint64_t number = next_id_++;
    std::string id(16, '0');
    for (auto digit = id.rbegin(); digit != id.rend(); ++digit, number >>= 4) *digit = kDigits[number & 15];
    return id;
}

void Service::note(const Request& request, const Response& response, const std::string& id, const Record& record,
                   double seconds) {
    metrics_.count_request(record.route, method_label(request.method), response.status, seconds, response.body.size());
    log_.request({id, request.method, record.route, response.status, record.queue_seconds * 1e3,
                  record.core_seconds * 1e3, seconds * 1e3, request.body.size(), response.body.size()});
}

Response Service::admin_problem(int status) { return to_response(http_problem(status), "none"); }

Response Service::handle_admin(const Request& request) const {
    if (request.method != "GET" && request.method != "HEAD") return admin_problem(405);
    const Pool::Stats stats = pool_.stats();
    if (request.path == "/livez") return plain(200, "alive\n");
    if (request.path == "/readyz") {
        if (is_draining_) return plain(503, "draining\n");
        return stats.queued < stats.capacity ? plain(200, "ready\n") : plain(503, "full\n");
    }
    if (request.path == "/metrics") {
        Response response =
            plain(200, metrics_.text({static_cast<std::uint64_t>(stats.workers), static_cast<std::uint64_t>(stats.busy),
                                      stats.queued, stats.capacity, log_.dropped()}));
        response.content_type = "text/plain; version=0.0.4; charset=utf-8";
        return response;
    }
    return admin_problem(404);
}

Response Service::refuse(int status) {
    const std::string id = next_id();
    Response response = to_response(http_problem(status), id);
    response.headers.emplace_back("Request-Id", id);
    note({}, response, id, {}, 0);
    return response;
}

}  // namespace tuftwave::server
