#include "http/listener.hpp"

#include <httplib.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <exception>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "http/connection.hpp"
#include "http/framing.hpp"

// The library accepts connections, parses the head of a request and writes the answer. Reading is ours (connection.hpp,
// framing.hpp), because what Debian ships (0.11.4 and 0.18.7) has no limit on lines, headers, chunked bodies and total
// time, and takes doubtful framing. So its content readers, routes, decompression and multipart parser never run.

namespace tuftwave::server {
namespace {

constexpr std::size_t kRequestsPerConnection = 1'000;
constexpr int kBacklog = 1'024;  // the library's own is 5: a burst of connections would wait a second and more
constexpr ConnectionLimits kLimits;

/// Shows a connection to the library, which may read heads from it and write answers to it.
class HeadStream final : public httplib::Stream {
  public:
    explicit HeadStream(Connection& connection) : connection_(connection) {}

    bool is_readable() const override { return true; }
    bool is_writable() const override { return true; }
    ssize_t read(char* to, const size_t count) override {
        if (count == 0) return 0;
        const int byte = connection_.head_byte();
        if (byte < 0) return -1;
        *to = static_cast<char>(byte);
        return 1;
    }
    ssize_t write(const char* bytes, const size_t count) override {
        return connection_.write({bytes, count}) ? static_cast<ssize_t>(count) : -1;
    }
    void get_remote_ip_and_port(std::string&, int&) const override {}  // nobody asks
    void get_local_ip_and_port(std::string&, int&) const override {}
    socket_t socket() const override { return connection_.descriptor(); }

  private:
    Connection& connection_;
};

/// The connection that this thread serves: the library's handlers have no other way to learn it.
thread_local Connection* this_connection = nullptr;

/// Where Accept-Encoding waits while the library answers: no client can send a name with a colon.
const std::string kHiddenAcceptEncoding = ":accept-encoding";

/// Keeps the library from acting on these by itself: it would cut and repeat the answer (Range), and pack it with
/// brotli at its slowest.
void disarm(httplib::Request& request) {
    request.ranges.clear();
    for (const char* name : {"Range", "If-Range"}) request.headers.erase(name);
    std::vector<std::string> codings;
    const auto [begin, end] = request.headers.equal_range("Accept-Encoding");
    for (auto coding = begin; coding != end; ++coding) codings.push_back(coding->second);
    request.headers.erase("Accept-Encoding");
    for (std::string& coding : codings) request.headers.emplace(kHiddenAcceptEncoding, std::move(coding));
}

/// Lower case, and without the four that the library adds (and that a client could send as well).
NameValues headers_of(const httplib::Request& from) {
    NameValues headers;
    for (const auto& [name, value] : from.headers) {
        if (name == "REMOTE_ADDR" || name == "REMOTE_PORT" || name == "LOCAL_ADDR" || name == "LOCAL_PORT") continue;
        std::string lower = name == kHiddenAcceptEncoding ? name.substr(1) : name;
        for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
        headers.emplace_back(std::move(lower), value);
    }
    return headers;
}

void deliver(Response from, httplib::Response& to) {
    to.status = from.status;
    to.body = std::move(from.body);
    to.headers.erase("Content-Type");
    if (!from.content_type.empty()) to.set_header("Content-Type", from.content_type);
    for (const auto& [name, value] : from.headers) to.set_header(name, value);
}

/// An answer that the library does not write, since it never saw a whole head.
std::string bare_message(const Response& response) {
    std::string message = "HTTP/1.1 " + std::to_string(response.status) +
                          " Refused\r\nContent-Type: " + response.content_type +
                          "\r\nContent-Length: " + std::to_string(response.body.size()) +
                          "\r\nX-Content-Type-Options: nosniff\r\nConnection: close\r\n";
    for (const auto& [name, value] : response.headers) message += name + ": " + value + "\r\n";
    return message + "\r\n" + response.body;
}

using SetUp = std::function<void(httplib::Request&)>;

/// process_request of 0.11.4 and of 0.18.7: whichever the library has is called.
[[maybe_unused]] bool process(httplib::Server& server,
                              bool (httplib::Server::*request)(httplib::Stream&, bool, bool&, const SetUp&),
                              httplib::Stream& stream, const bool is_last, bool& is_closed, const SetUp& set_up) {
    return (server.*request)(stream, is_last, is_closed, set_up);
}
[[maybe_unused]] bool process(httplib::Server& server,
                              bool (httplib::Server::*request)(httplib::Stream&, const std::string&, int,
                                                               const std::string&, int, bool, bool&, const SetUp&),
                              httplib::Stream& stream, const bool is_last, bool& is_closed, const SetUp& set_up) {
    return (server.*request)(stream, "", 0, "", 0, is_last, is_closed, set_up);
}

}  // namespace

class Listener::Server final : public httplib::Server {
  public:
    Server(ListenerOptions options, Handle handle, Problem problem)
        : options_(std::move(options)), handle_(std::move(handle)), problem_(std::move(problem)) {
        set_tcp_nodelay(true);
        set_socket_options([](const socket_t sock) {
            // Not SO_REUSEPORT, the library's choice, with which a forgotten server silently takes half of the
            // requests.
            const int yes = 1;
            ::setsockopt(sock, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
        });
        set_keep_alive_max_count(kRequestsPerConnection);  // these two only say what kLimits does
        set_keep_alive_timeout(std::chrono::duration_cast<std::chrono::seconds>(kLimits.idle).count());
        new_task_queue = [count = static_cast<std::size_t>(options_.connections)] {
            return new httplib::ThreadPool(count);
        };
        set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
            deliver(answer(request), response);
            return HandlerResponse::Handled;
        });
        set_error_handler(HandlerWithResponse([this](const httplib::Request& request, httplib::Response& response) {
            const_cast<httplib::Request&>(request).ranges.clear();  // they would be applied to the problem, too
            return explain(response);
        }));
        set_exception_handler([this](const httplib::Request&, httplib::Response& response, std::exception_ptr) {
            deliver(refused(500), response);
        });
        set_expect_100_continue_handler([this](const httplib::Request& request, httplib::Response& response) {
            const int refusal = early_refusal(request);
            if (refusal != 0) response.status = refusal;
            return refusal != 0 ? refusal : 100;
        });
        set_post_routing_handler([this](const httplib::Request&, httplib::Response& response) { finish(response); });
    }

    ~Server() override {
        if (listening_ >= 0) ::close(listening_);
    }

    std::variant<int, std::string> bind() {
        errno = 0;
        const int port = options_.port == 0                           ? bind_to_any_port(options_.host)
                         : bind_to_port(options_.host, options_.port) ? options_.port
                                                                      : -1;
        if (port < 0 || ::listen(svr_sock_, kBacklog) != 0) {
            const std::string reason = errno != 0 ? std::generic_category().message(errno) : "no such address";
            return "cannot listen on " + options_.host + ":" + std::to_string(options_.port) + ": " + reason;
        }
        listening_ = svr_sock_;
        return port;
    }

    bool serve() {
        if (listen_after_bind()) return true;
        listening_ = -1;  // the library has closed it
        return stopping_;
    }

    void drain() { draining_ = true; }

    /// Unlike the library's stop() this also works before it serves, and leaves the number taken until it is not used
    /// by any thread any more.
    void halt() {
        stopping_ = true;
        const socket_t listening = svr_sock_.exchange(INVALID_SOCKET);
        if (listening != INVALID_SOCKET) ::shutdown(listening, SHUT_RDWR);
    }

  private:
    /// Serves one connection. Overrides the library's loop, on one of its threads.
    bool process_and_close_socket(const socket_t sock) override {
        try {
            Connection connection(sock, kLimits, stopping_);
            this_connection = &connection;
            for (std::size_t i = 1; i <= kRequestsPerConnection; ++i) {
                if (!connection.wait_for_request() || !serve_request(connection, i == kRequestsPerConnection)) break;
            }
        } catch (...) {  // out of memory: this connection goes, the process stays
        }
        this_connection = nullptr;
        return true;
    }

    /// @return  whether another request may follow
    bool serve_request(Connection& connection, const bool is_last) {
        HeadStream stream(connection);
        bool is_closed = false;
        const auto set_up = [&](httplib::Request& request) {
            connection.head_ended();
            disarm(request);
        };
        const bool is_sound = process(*this, &Server::process_request, stream, is_last, is_closed, set_up);
        if (connection.fault() != 0 && !connection.has_answered())
            connection.write(bare_message(problem_(connection.fault())));
        return is_sound && !is_closed && !connection.is_closing();
    }

    /// Closes the connection, since what follows on it may be no request.
    Response refused(const int status) const {
        this_connection->close_after_this();
        return problem_(status);
    }

    Response answer(const httplib::Request& from) const {
        Request request{from.method, "", {}, headers_of(from), ""};
        std::optional<Target> target = parse_target(from.target);
        const Framing framing = framing_of(request, from.version == "HTTP/1.0");
        if (!target || framing.fault != 0) return refused(target ? framing.fault : 400);
        const auto source = [](char* to, const std::size_t count) { return this_connection->read(to, count); };
        Body body = read_body(source, framing, options_.body_limit(target->path));
        if (!body.is_over) this_connection->close_after_this();
        if (const int slow = this_connection->fault(); slow != 0) return refused(slow);
        if (body.fault != 0) return problem_(body.fault);
        request.path = std::move(target->path);
        request.query = std::move(target->query);
        request.body = std::move(body.bytes);
        try {
            return handle_(request);
        } catch (...) {  // what it says is for us, never for a client
            return problem_(500);
        }
    }

    /// Whether a client that asks before it sends a body should not: the status, or 0.
    int early_refusal(const httplib::Request& from) const {
        const Framing framing = framing_of({from.method, "", {}, headers_of(from), ""}, from.version == "HTTP/1.0");
        const std::optional<Target> target = parse_target(from.target);
        if (!target || framing.fault != 0) return target ? framing.fault : 400;
        return framing.length > options_.body_limit(target->path) ? 413 : 0;
    }

    /// Gives the library's own errors a body. Ours have one, and with it a type.
    HandlerResponse explain(httplib::Response& response) const {
        if (response.has_header("Content-Type")) return HandlerResponse::Unhandled;
        const int fault = this_connection->fault();
        deliver(refused(fault != 0 ? fault : response.status), response);
        return HandlerResponse::Handled;
    }

    /// The last word on the headers of every answer.
    void finish(httplib::Response& response) const {
        response.set_header("X-Content-Type-Options", "nosniff");
        response.headers.erase("Accept-Ranges");  // the library claims it for HEAD
        if (response.status == 204 || response.status == 304) response.headers.erase("Content-Length");
        if (draining_) this_connection->close_after_this();
        if (!this_connection->is_closing()) return;
        response.headers.erase("Keep-Alive");
        response.headers.erase("Connection");
        response.set_header("Connection", "close");
    }

    const ListenerOptions options_;
    const Handle handle_;
    const Problem problem_;
    std::atomic<bool> draining_ = false;
    std::atomic<bool> stopping_ = false;
    int listening_ = -1;
};

Listener::Listener(ListenerOptions options, Handle handle, Problem problem)
    : server_(std::make_unique<Server>(std::move(options), std::move(handle), std::move(problem))) {}

Listener::~Listener() = default;

std::variant<int, std::string> Listener::bind() { return server_->bind(); }

bool Listener::serve() { return server_->serve(); }

void Listener::drain() { server_->drain(); }

void Listener::stop() { server_->halt(); }

}  // namespace tuftwave::server
