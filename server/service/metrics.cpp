#include "service/metrics.hpp"

#include "tuftwave/limits.hpp"
#include "version.hpp"

namespace tuftwave::server {
namespace {

void describe(std::string& out, const std::string& name, const char* type, const char* help) {
    out += "# HELP " + name + " " + help + "\n# TYPE " + name + " " + type + "\n";
}

void sample(std::string& out, const std::string& name, const std::string& labels, const std::string& value) {
    out += name + (labels.empty() ? "" : "{" + labels + "}") + " " + value + "\n";
}

void single(std::string& out, const std::string& name, const char* type, const char* help, std::uint64_t value) {
    describe(out, name, type, help);
    sample(out, name, "", std::to_string(value));
}

}  // namespace

void Metrics::Histogram::add(double seconds) {
    std::size_t bucket = 0;
    while (bucket < kBounds.size() && seconds > kBounds[bucket]) ++bucket;
    ++buckets[bucket];
    sum += seconds;
}

void Metrics::Histogram::write(std::string& out, const std::string& name, const std::string& labels) const {
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < buckets.size(); ++i) {
        total += buckets[i];
        const std::string bound = i < kBounds.size() ? to_text(kBounds[i]) : "+Inf";
        sample(out, name + "_bucket", labels + (labels.empty() ? "" : ",") + "le=\"" + bound + "\"",
               std::to_string(total));
    }
    sample(out, name + "_sum", labels, to_text(sum));
    sample(out, name + "_count", labels, std::to_string(total));
}

void Metrics::count_request(const std::string& route, const std::string& method, int status, double seconds,
                            std::size_t bytes_out) {
    const std::lock_guard lock(mutex_);
    ++requests_[{route, method, status}];
    durations_[route].add(seconds);
    bytes_out_ += bytes_out;
}

void Metrics::count_queue_wait(double seconds) {
    const std::lock_guard lock(mutex_);
    queue_wait_.add(seconds);
}

std::string Metrics::text(const Gauges& gauges) const {
    const std::lock_guard lock(mutex_);
    std::string out;
    describe(out, "tuftwave_build_info", "gauge", "The running version.");
    sample(out, "tuftwave_build_info", std::string("version=\"") + kVersion + "\"", "1");
    describe(out, "tuftwave_http_requests_total", "counter", "Requests answered.");
    for (const auto& [key, count] : requests_) {
        const auto& [route, method, status] = key;
        sample(out, "tuftwave_http_requests_total",
               "route=\"" + route + "\",method=\"" + method + "\",code=\"" + std::to_string(status) + "\"",
               std::to_string(count));
    }
    describe(out, "tuftwave_http_request_duration_seconds", "histogram", "From a complete request to its answer.");
    for (const auto& [route, histogram] : durations_)
        histogram.write(out, "tuftwave_http_request_duration_seconds", "route=\"" + route + "\"");
    describe(out, "tuftwave_pool_queue_wait_seconds", "histogram", "Waiting for a worker.");
    queue_wait_.write(out, "tuftwave_pool_queue_wait_seconds", "");
    single(out, "tuftwave_http_requests_in_flight", "gauge", "Requests being answered.", in_flight_);
    single(out, "tuftwave_response_bytes_total", "counter", "Bytes of answer bodies.", bytes_out_);
    single(out, "tuftwave_pool_workers", "gauge", "Worker threads.", gauges.workers);
    single(out, "tuftwave_pool_busy", "gauge", "Workers at work.", gauges.busy);
    single(out, "tuftwave_pool_queue_depth", "gauge", "Computations waiting.", gauges.queued);
    single(out, "tuftwave_pool_queue_capacity", "gauge", "Computations that may wait.", gauges.capacity);
    describe(out, "tuftwave_pool_saturation", "gauge", "0: nothing to do; 0.5: every worker is busy; 1: full.");
    sample(out, "tuftwave_pool_saturation", "", to_text(gauges.saturation));
    const Traffic& traffic = gauges.traffic;
    single(out, "tuftwave_connections", "gauge", "Connections open.", traffic.connections);
    single(out, "tuftwave_connections_accepted_total", "counter", "Connections accepted.", traffic.accepted);
    single(out, "tuftwave_connections_refused_total", "counter", "Connections refused since too many were open.",
           traffic.turned_away);
    single(out, "tuftwave_request_body_bytes", "gauge", "Bytes of bodies held.", traffic.body_bytes);
    single(out, "tuftwave_unsent_answer_bytes", "gauge", "Bytes of answers that clients have not taken.",
           traffic.answer_bytes);
    single(out, "tuftwave_log_lines_dropped_total", "counter", "Log lines that nobody read in time.",
           gauges.dropped_log_lines);
    return out;
}

}  // namespace tuftwave::server
