#include "http/run.hpp"

#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>
#include <thread>
#include <variant>

#include "api/routes.hpp"
#include "exec/pool.hpp"
#include "http/listener.hpp"
#include "log/log.hpp"
#include "service/service.hpp"
#include "version.hpp"

namespace tuftwave::server {
namespace {

constexpr int kAdminConnections = 4;  // probes and one scraper
constexpr std::size_t kAdminBodyBytes = 1'024;

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

/// A listener and the thread that accepts for it.
class Door {
  public:
    Door(ListenerOptions options, Listener::Handle handle, Listener::Problem problem)
        : host_(options.host), listener_(std::move(options), std::move(handle), std::move(problem)) {}
    ~Door() { close(); }

    /// @return  whether it has its port; otherwise it says why not
    bool bind() {
        const auto bound = listener_.bind();
        if (const auto* error = std::get_if<std::string>(&bound))
            std::fprintf(stderr, "tuftwave-server: %s\n", error->c_str());
        if (const int* port = std::get_if<int>(&bound)) address_ = url(host_, *port);
        return !address_.empty();
    }
    /// Sends this process SIGTERM if it ends by itself.
    void open() {
        thread_ = std::thread([this] {
            if (listener_.serve()) return;
            has_failed_ = true;
            ::kill(::getpid(), SIGTERM);
        });
    }
    void drain() { listener_.drain(); }
    void close() {
        listener_.stop();
        if (thread_.joinable()) thread_.join();
    }
    const std::string& address() const { return address_; }
    bool has_failed() const { return has_failed_; }

  private:
    const std::string host_;
    Listener listener_;
    std::string address_;
    std::atomic<bool> has_failed_ = false;
    std::thread thread_;
};

}  // namespace

int run(const Config& config) {
    const EndSignals signals;
    LogOptions log_options;
    log_options.level = config.log_level;
    log_options.format = config.log_format;
    Log log(log_options);
    Pool pool(worker_count(config), static_cast<std::size_t>(config.queue));
    Service service(config, pool, log);
    Door front(
        {config.host, config.port, config.connections, body_limit},
        [&](const Request& request) { return service.handle(request); },
        [&](int status) { return service.refuse(status); });
    Door admin(
        {config.admin_host, config.admin_port, kAdminConnections, [](const std::string&) { return kAdminBodyBytes; }},
        [&](const Request& request) { return service.handle_admin(request); }, Service::admin_problem);
    if (!front.bind() || !admin.bind()) return 1;
    front.open();
    admin.open();
    std::printf("tuftwave-server %s listening on %s, admin on %s\n", kVersion, front.address().c_str(),
                admin.address().c_str());
    std::fflush(stdout);
    log.event(Log::Level::kInfo, "ready",
              {{"version", kVersion}, {"address", front.address()}, {"admin", admin.address()}});

    if (config.connections <= config.queue + worker_count(config))
        log.event(Log::Level::kWarn, "the queue cannot fill: connections <= queue + workers, so nobody is refused");

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
    return front.has_failed() || admin.has_failed() ? 1 : 0;
}

}  // namespace tuftwave::server
