#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <variant>

#include "client.hpp"
#include "http/listener.hpp"

namespace tuftwave::server::served {

inline constexpr std::size_t kBodyLimit = 1'000'000, kLargeAnswer = 20'000'000;

using Handle = std::function<Response(const Request&)>;

/// Says what it was asked, in a form that the tests can look into.
inline Response echo(const Request& request) {
    if (request.path == "/throw") throw std::runtime_error("secret");
    if (request.path == "/missing") return {404, "application/problem+json", "mine", {{"X-Mine", "1"}}};
    if (request.path == "/nothing") return {204, "", "", {}};
    if (request.path == "/json") return {200, "application/json", std::string(5'000, ' '), {}};
    if (request.path == "/large") return {200, "text/plain", std::string(kLargeAnswer, 'x'), {}};
    std::string text = request.method + " " + request.path + "\n";
    for (const auto& [name, value] : request.query) text += "?" + name + "=" + value + "\n";
    for (const auto& [name, value] : request.headers) text += name + ": " + value + "\n";
    return {200, "text/plain", text + "<" + request.body + ">", {}};
}

inline Response problem(const int status) {
    return {status, "application/problem+json", "problem " + std::to_string(status), {}};
}

inline Answerer answering(Handle handle) {
    const Admission admission{kBodyLimit, [handle = std::move(handle)](const Request& request, const std::stop_source&,
                                                                       const Reply& reply) { reply(handle(request)); }};
    return {[admission](const Request& head, bool) -> std::variant<Admission, Response> {
                if (head.path == "/early") return problem(404);
                return admission;
            },
            problem};
}

inline ListenerOptions options() {
    ListenerOptions options;
    options.connections = 8;
    options.threads = 2;
    return options;
}

/// A listener on a free port, with a thread that serves.
class Served {
  public:
    explicit Served(Answerer answerer = answering(echo), ListenerOptions wanted = options())
        : listener_(std::move(wanted), std::move(answerer)) {
        const auto bound = listener_.bind();
        if (const auto* error = std::get_if<std::string>(&bound)) ADD_FAILURE() << *error;
        if (const int* port = std::get_if<int>(&bound)) port_ = *port;
        thread_ = std::thread([this] { listener_.serve(); });
    }
    ~Served() { stop(); }
    void stop() {
        listener_.stop();
        if (thread_.joinable()) thread_.join();
    }
    int port() const { return port_; }
    Listener& listener() { return listener_; }
    const Listener& listener() const { return listener_; }

  private:
    Listener listener_;
    int port_ = 0;
    std::thread thread_;
};

inline std::string head(const std::string& first_line, const std::string& more = "") {
    return first_line + " HTTP/1.1\r\nHost: h\r\n" + more + "\r\n";
}

inline std::string post(const std::string& path, const std::string& body, const std::string& more = "") {
    return head("POST " + path, more + "Content-Length: " + std::to_string(body.size()) + "\r\n") + body;
}

inline std::string repeated(const std::string& text, const int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// What a fresh connection answers.
inline std::string answer(const Served& served, const std::string& request) {
    Client client(served.port());
    client.say(request);
    return client.hear();
}

inline bool is_problem(const std::string& text, const int status) {
    const std::string code = std::to_string(status);
    return text.starts_with("HTTP/1.1 " + code + " ") && text.ends_with("\r\n\r\nproblem " + code) &&
           has(text, "Content-Type: application/problem+json\r\n") && has(text, "X-Content-Type-Options: nosniff\r\n");
}

}  // namespace tuftwave::server::served
