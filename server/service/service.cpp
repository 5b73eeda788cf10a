#include "service/service.hpp"

#include <memory>
#include <new>
#include <optional>
#include <utility>

#include "memory/reserve.hpp"
#include "service/small_work.hpp"

namespace tuftwave::server {
namespace {

constexpr std::uint64_t kSmallBodyBytes = 64 * 1024;  // worth reading even when there is no room for the work

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
    if (status == server::status(ProblemCode::kBusy)) return busy();
    constexpr ProblemCode kCodes[] = {ProblemCode::kNotFound,
                                      ProblemCode::kMethodNotAllowed,
                                      ProblemCode::kTooSlow,
                                      ProblemCode::kLengthRequired,
                                      ProblemCode::kTooLarge,
                                      ProblemCode::kUriTooLong,
                                      ProblemCode::kUnsupportedMediaType,
                                      ProblemCode::kExpectationFailed,
                                      ProblemCode::kHeadersTooLarge,
                                      ProblemCode::kNotImplemented,
                                      ProblemCode::kVersionNotSupported};
    for (const ProblemCode code : kCodes) {
        if (server::status(code) == status) return {code, "", {}, {}};
    }
    return {status >= 500 ? ProblemCode::kInternal : ProblemCode::kBadRequest, "", {}, {}};
}

}  // namespace

Service::Service(const Config& config, Access& access, Pool& pool, Log& log)
    : small_limits_(small_limits(limits_)),
      access_(access),
      pool_(pool),
      log_(log),
      deadlines_(std::chrono::duration<double>(config.deadline_seconds)),
      next_id_(static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count())) {}

std::variant<Admission, Response> Service::admit(const Request& head, const bool is_whole) {
    const auto refused = [&](Answer answer) { return conclude(head, std::move(answer), {}); };
    if (std::optional<Response> preflight = access_.preflight(head)) return refused(*std::move(preflight));
    if (head.method == "OPTIONS") {
        if (const std::string allowed = allowed_methods(head.path); !allowed.empty())
            return refused(Response{204, "", "", {{"Allow", allowed}}});
    }
    const auto found = find_route(head.method, head.path);
    if (const auto* problem = std::get_if<Problem>(&found)) return refused(*problem);
    const Route& route = *std::get<const Route*>(found);
    auto admitted = access_.admit(head);
    if (auto* problem = std::get_if<Problem>(&admitted)) return refused(*std::move(problem));
    const Visitor visitor = std::get<Visitor>(admitted);
    const std::uint64_t bytes = visitor.paid_bytes;  // announced; 0 for a chunked body
    if (bytes > body_limit(head.path)) return refused(Problem{ProblemCode::kTooLarge, "", {}, {}});
    const bool is_cheaper_now = is_whole || bytes > kSmallBodyBytes;  // than to read on and keep the connection
    if (route.computes && is_cheaper_now && !may_be_small(route, bytes) && pool_.stats().is_full)
        return conclude(head, busy(), {std::string(route.path), is_whole ? bytes : 0});
    return Admission{body_limit(head.path),
                     [this, &route, visitor](Request request, std::stop_source stop, const Reply& reply) {
                         answer(route, visitor, std::move(request), std::move(stop), reply);
                     }};
}

void Service::answer(const Route& route, const Visitor& visitor, Request request, std::stop_source stop,
                     const Reply& reply) {
    std::optional<Response> made;
    if (!route.computes) made = answer_at_once(route, visitor, request, limits_);
    if (may_be_small(route, request.body.size())) made = answer_at_once(route, visitor, request, small_limits_);
    if (made) return reply(*std::move(made));
    compute(route, visitor, std::move(request), std::move(stop), reply);
}

std::optional<Response> Service::answer_at_once(const Route& route, const Visitor& visitor, const Request& request,
                                                const Limits& limits) {
    const Metrics::InFlight in_flight(metrics_);
    Record record{std::string(route.path), request.body.size()};
    const auto begin = Clock::now();
    Answer made = run(route, request, {limits, InOrder(), {}});
    if (route.computes && std::holds_alternative<Problem>(made)) return {};  // perhaps of the smaller limits only
    record.core_seconds = record.total_seconds = seconds_between(begin, Clock::now());
    access_.charge(visitor, record.core_seconds, record.bytes_in);
    return conclude(request, std::move(made), record);
}

/// All that a computation needs, from its acceptance to its answer.
struct Service::Order {
    Order(Service& service, const Route& its_route, const Visitor& its_visitor, Request&& its_request,
          std::stop_source&& stop, const Reply& reply)
        : route(its_route),
          visitor(its_visitor),
          request(std::move(its_request)),
          computation(std::move(stop),
                      [this, &service, reply](Computation::Outcome outcome) {
                          reply(service.conclude(*this, std::move(outcome)));
                      }),
          watch(service.deadlines_, computation),
          in_flight(service.metrics_) {}

    const Route& route;
    const Visitor visitor;
    const Request request;
    Computation computation;
    const Deadlines::Watch watch;  // once it has ended, the service may, too
    const Metrics::InFlight in_flight;
};

void Service::compute(const Route& route, const Visitor& visitor, Request request, std::stop_source stop,
                      const Reply& reply) {
    const auto order = std::make_shared<Order>(*this, route, visitor, std::move(request), std::move(stop), reply);
    const bool is_accepted = pool_.submit([this, order] {
        if (!order->computation.start()) return;
        const std::stop_token token = order->computation.stop_token();
        order->computation.finish(run(order->route, order->request, {limits_, pool_.for_each(), token}));
    });
    if (!is_accepted && order->computation.start()) order->computation.finish(busy());
}

Response Service::conclude(const Order& order, Computation::Outcome outcome) {
    Record record{std::string(order.route.path), order.request.body.size()};
    record.queue_seconds = outcome.queue_seconds;
    record.core_seconds = outcome.core_seconds;
    record.total_seconds = outcome.queue_seconds + outcome.core_seconds;
    metrics_.count_queue_wait(record.queue_seconds);
    access_.charge(order.visitor, record.core_seconds, record.bytes_in);
    return conclude(order.request, outcome.answer ? *std::move(outcome.answer) : Answer(busy()), record);
}

Response Service::conclude(const Request& request, Answer made, const Record& record) {
    const std::string id = next_id();
    Response response = std::holds_alternative<Problem>(made) ? to_response(std::get<Problem>(made), id)
                                                              : std::get<Response>(std::move(made));
    response.headers.emplace_back("Request-Id", id);
    access_.add_headers(request, response);
    metrics_.count_request(record.route, method_label(request.method), response.status, record.total_seconds,
                           response.content().size());
    log_.request({id, request.method, record.route, response.status, record.queue_seconds * 1e3,
                  record.core_seconds * 1e3, record.total_seconds * 1e3, record.bytes_in, response.content().size()});
    return response;
}

Answer Service::run(const Route& route, const Request& request, const Context& context) const {
    try {
        if (context.stop.stop_requested()) return Problem{ProblemCode::kDeadline, "", {}, {}};
        memory::hold_reserve();
        Answer made = route.run(request, context);
        if (context.stop.stop_requested()) return Problem{ProblemCode::kDeadline, "", {}, {}};
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

Response Service::admin_problem(int status) { return to_response(http_problem(status), "none"); }

Response Service::handle_admin(const Request& request, const Traffic& traffic) const {
    if (request.method != "GET" && request.method != "HEAD") return admin_problem(405);
    const Pool::Stats stats = pool_.stats();
    if (request.path == "/livez") return plain(200, "alive\n");
    if (request.path == "/readyz") {
        if (is_draining_) return plain(503, "draining\n");
        return plain(200, stats.is_full ? "full\n" : "ready\n");
    }
    if (request.path == "/metrics") {
        Response response =
            plain(200, metrics_.text({static_cast<std::uint64_t>(stats.workers), static_cast<std::uint64_t>(stats.busy),
                                      stats.queued, stats.capacity, stats.saturation, log_.dropped(), traffic}));
        response.content_type = "text/plain; version=0.0.4; charset=utf-8";
        return response;
    }
    return admin_problem(404);
}

Response Service::refuse(const int status) { return conclude({}, http_problem(status), {}); }

}  // namespace tuftwave::server
