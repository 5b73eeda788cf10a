#include "http/run.hpp"

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <variant>

#include "access/access.hpp"
#include "exec/pool.hpp"
#include "http/listener.hpp"
#include "log/log.hpp"
#include "memory/buffers.hpp"
#include "memory/heap.hpp"
#include "service/service.hpp"
#include "version.hpp"

namespace tuftwave::server {
namespace {

constexpr std::size_t kAdminConnections = 256;  // probes and scrapers
constexpr std::size_t kMiB = 1024 * 1024;
constexpr int kMostServing = 8;  // threads for connections, each of which wakes 20 times a second
constexpr int kWrongUsage = 2;
constexpr rlim_t kOtherDescriptors = 2'048;  // than connections

int worker_count(const Config& config) {
    return config.workers > 0 ? config.workers : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

std::string url(const std::string& host, const int port) {
    const bool is_ipv6 = host.find(':') != std::string::npos;
    return "http://" + (is_ipv6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

/// SIGTERM and SIGINT, held back in this thread and all that it will start.
class EndSignals {
  public:
    EndSignals() {
        sigemptyset(&set_);
        sigaddset(&set_, SIGTERM);
        sigaddset(&set_, SIGINT);
        pthread_sigmask(SIG_BLOCK, &set_, nullptr);
        std::signal(SIGPIPE, SIG_IGN);
    }
    void wait() const {
        int number = 0;
        sigwait(&set_, &number);
    }
    /// A handler and not the default action, which a process with number 1, as in a container, does not have.
    void let_the_next_one_end_the_process() const {
        for (const int number : {SIGTERM, SIGINT}) std::signal(number, [](int) { ::_exit(1); });
        pthread_sigmask(SIG_UNBLOCK, &set_, nullptr);
    }

  private:
    sigset_t set_;
};

/// A listener and its thread.
class Door {
  public:
    Door(ListenerOptions options, Answerer answerer)
        : host_(options.host), listener_(std::move(options), std::move(answerer)) {}
    ~Door() { close(); }

    /// @return  whether it has its port; otherwise it says why not
    bool bind() {
        const auto bound = listener_.bind();
        if (const auto* error = std::get_if<std::string>(&bound))
            std::fprintf(stderr, "tuftwave-server: %s\n", error->c_str());
        if (const int* port = std::get_if<int>(&bound)) address_ = url(host_, *port);
        return !address_.empty();
    }
    void open() {
        thread_ = std::thread([this] { listener_.serve(); });
    }
    void drain() { listener_.drain(); }
    void close() {
        listener_.stop();
        if (thread_.joinable()) thread_.join();
    }
    const std::string& address() const { return address_; }
    Traffic traffic() const {
        const Listener::Stats stats = listener_.stats();
        return {stats.connections, stats.accepted, stats.turned_away, stats.body_bytes, stats.answer_bytes};
    }

  private:
    const std::string host_;
    Listener listener_;
    std::string address_;
    std::thread thread_;
};

ListenerOptions public_options(const Config& config) {
    ListenerOptions options{config.host, config.port, static_cast<std::size_t>(config.connections)};
    options.threads = std::min(worker_count(config), kMostServing);
    options.body_memory = static_cast<std::size_t>(config.body_mib) * kMiB;
    options.answer_memory = static_cast<std::size_t>(config.answer_mib) * kMiB;
    return options;
}

/// What needs no body and is answered on the spot.
Admission at_once(std::function<Response(const Request&)> answer) {
    return {0, [answer = std::move(answer)](const Request& request, const std::stop_source&, const Reply& reply) {
                reply(answer(request));
            }};
}

/// As many as there may be connections, if the system allows.
/// @return  whether it does
bool allow_descriptors(const rlim_t count) {
    rlimit limit{};
    ::getrlimit(RLIMIT_NOFILE, &limit);
    if (limit.rlim_cur >= count) return true;
    limit.rlim_cur = std::min(count, limit.rlim_max);
    ::setrlimit(RLIMIT_NOFILE, &limit);
    return limit.rlim_cur >= count;
}

}  // namespace

int run(const Config& config) {
    const EndSignals signals;
    memory::set_up_heap();
    memory::keep_at_most(static_cast<std::size_t>(config.answer_mib) * kMiB / 2);
    const auto opened = Access::open(config);
    if (const auto* error = std::get_if<UsageError>(&opened)) {
        std::fprintf(stderr, "tuftwave-server: %s\n", error->message.c_str());
        return kWrongUsage;
    }
    Access& access = *std::get<std::unique_ptr<Access>>(opened);
    LogOptions log_options;
    log_options.level = config.log_level;
    log_options.format = config.log_format;
    Log log(log_options);
    Pool pool(worker_count(config), static_cast<std::size_t>(config.queue),
              std::chrono::duration<double>(config.queue_seconds));
    Service service(config, access, pool, log);
    Door front(public_options(config),
               {[&](const Request& head, const bool is_whole) { return service.admit(head, is_whole); },
                [&](const int status) { return service.refuse(status); }});
    const Admission ask_admin =
        at_once([&](const Request& request) { return service.handle_admin(request, front.traffic()); });
    Door admin({config.admin_host, config.admin_port, kAdminConnections},
               {[&](const Request&, bool) { return ask_admin; }, Service::admin_problem});
    if (!front.bind() || !admin.bind()) return 1;
    front.open();
    admin.open();
    std::printf("tuftwave-server %s listening on %s, admin on %s\n", kVersion, front.address().c_str(),
                admin.address().c_str());
    std::fflush(stdout);
    log.event(Log::Level::kInfo, "ready", {{"address", front.address()}, {"admin", admin.address()}});

    if (!access.warning().empty()) log.event(Log::Level::kWarn, access.warning());
    if (!allow_descriptors(static_cast<rlim_t>(config.connections) + kOtherDescriptors))
        log.event(Log::Level::kWarn, "fewer files may be open than connections: some will wait to be accepted");

    signals.wait();
    signals.let_the_next_one_end_the_process();
    log.event(Log::Level::kInfo, "draining");
    service.start_draining();
    front.drain();
    std::this_thread::sleep_for(std::chrono::duration<double>(config.drain_seconds));
    front.close();
    pool.stop();
    admin.close();
    log.event(Log::Level::kInfo, "stopped");
    return 0;
}

}  // namespace tuftwave::server
