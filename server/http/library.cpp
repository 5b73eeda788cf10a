#include "http/library.hpp"

#include <httplib.h>

#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <string_view>
#include <utility>

namespace tuftwave::server {
namespace {

/// A request to read, and room for the head of an answer.
class MemoryStream final : public httplib::Stream {
  public:
    explicit MemoryStream(const std::string_view request) : unread_(request) {}

    bool is_readable() const override { return !unread_.empty(); }
    bool is_writable() const override { return true; }
    ssize_t read(char* to, const size_t count) override {
        const std::size_t part = std::min(count, unread_.size());
        std::copy_n(unread_.data(), part, to);
        unread_.remove_prefix(part);
        return static_cast<ssize_t>(part);
    }
    ssize_t write(const char* bytes, const size_t count) override {
        written.append(bytes, count);
        return static_cast<ssize_t>(count);
    }
    void get_remote_ip_and_port(std::string&, int&) const override {}
    void get_local_ip_and_port(std::string&, int&) const override {}
    socket_t socket() const override { return INVALID_SOCKET; }

    std::string written;

  private:
    std::string_view unread_;
};

using SetUp = std::function<void(httplib::Request&)>;

/// process_request of 0.11.4 and of 0.18.7: whichever the library has is called.
[[maybe_unused]] bool process(httplib::Server& server,
                              bool (httplib::Server::*request)(httplib::Stream&, bool, bool&, const SetUp&),
                              httplib::Stream& stream, bool& is_closed) {
    return (server.*request)(stream, false, is_closed, {});
}
[[maybe_unused]] bool process(httplib::Server& server,
                              bool (httplib::Server::*request)(httplib::Stream&, const std::string&, int,
                                                               const std::string&, int, bool, bool&, const SetUp&),
                              httplib::Stream& stream, bool& is_closed) {
    return (server.*request)(stream, "", 0, "", 0, false, is_closed, {});
}

constexpr std::string_view kEnd = "\r\n";
constexpr std::size_t kUsualBytes = 512;

/// What could end a header, or the head, early.
bool is_one_line(const std::string_view text) {
    return std::none_of(text.begin(), text.end(), [](const char c) { return c == '\r' || c == '\n'; });
}

void add_header(std::string& head, const std::string_view name, const std::string_view value) {
    if (!is_one_line(name) || !is_one_line(value)) return;
    for (const std::string_view part : {name, std::string_view(": "), value, kEnd}) head += part;
}

}  // namespace

class Library::Server final : public httplib::Server {
  public:
    /// "HTTP/1.1 404 Not Found" with its end. It asks the library once for each status.
    const std::string& status_line(const int status) {
        const std::lock_guard lock(mutex_);
        std::string& line = lines_[status];
        if (line.empty()) line = worded(status);
        return line;
    }

  private:
    std::string worded(const int status) {
        set_pre_routing_handler([status](const httplib::Request&, httplib::Response& response) {
            response.status = status;
            return HandlerResponse::Handled;
        });
        MemoryStream stream("GET / HTTP/1.1\r\nHost: h\r\n\r\n");
        bool is_closed = false;
        process(*this, &Server::process_request, stream, is_closed);
        return stream.written.substr(0, stream.written.find(kEnd) + kEnd.size());
    }

    std::mutex mutex_;
    std::map<int, std::string> lines_;
};

Library::Library() : server_(std::make_unique<Server>()) {}

Library::~Library() = default;

Message Library::message(const std::string_view method, Response answer, const bool closes) const {
    std::string head;
    head.reserve(kUsualBytes);
    head = server_->status_line(answer.status);
    if (!answer.content_type.empty()) add_header(head, "Content-Type", answer.content_type);
    for (const auto& [name, value] : answer.headers) add_header(head, name, value);
    add_header(head, "X-Content-Type-Options", "nosniff");
    if (answer.status != 204 && answer.status != 304)
        add_header(head, "Content-Length", std::to_string(answer.content().size()));
    if (closes) add_header(head, "Connection", "close");
    head += kEnd;
    if (method == "HEAD") return {std::move(head), "", {}};
    return {std::move(head), std::move(answer.body), answer.constant, answer.first};
}

}  // namespace tuftwave::server
