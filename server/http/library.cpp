#include "http/library.hpp"

#include <httplib.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <string_view>
#include <utility>

namespace tuftwave::server {
namespace {

/// A request to read, and room for the head of an answer.
class MemoryStream final : public httplib::Stream {
  public:
    explicit MemoryStream(const std::string& request) : unread_(request) {}

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

/// What this thread words: the library's handlers have no other way to learn it.
struct Wording {
    Response answer;
    bool closes;
    std::string body;  // taken out of the library's hands before it would copy it
};
thread_local Wording* wording = nullptr;

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

void deliver(httplib::Response& to) {
    Response& from = wording->answer;
    to.status = from.status;
    to.body = std::move(from.body);
    if (!from.content_type.empty()) to.set_header("Content-Type", from.content_type);
    for (const auto& [name, value] : from.headers) to.set_header(name, value);
}

/// The last word on the headers; the library has counted the body by now.
void finish(httplib::Response& to) {
    to.set_header("X-Content-Type-Options", "nosniff");
    to.headers.erase("Accept-Ranges");  // the library claims it for HEAD
    to.headers.erase("Keep-Alive");
    if (const std::string_view constant = wording->answer.constant; !constant.empty()) {
        to.headers.erase("Content-Length");  // of the body that it did not see
        to.set_header("Content-Length", std::to_string(constant.size()));
    }
    if (to.status == 204 || to.status == 304) to.headers.erase("Content-Length");
    if (wording->closes) {
        to.headers.erase("Connection");
        to.set_header("Connection", "close");
    }
    wording->body = std::exchange(to.body, {});
}

}  // namespace

class Library::Server final : public httplib::Server {
  public:
    Server() {
        set_pre_routing_handler([](const httplib::Request&, httplib::Response& response) {
            deliver(response);
            return HandlerResponse::Handled;
        });
        set_post_routing_handler([](const httplib::Request&, httplib::Response& response) { finish(response); });
    }

    bool word(httplib::Stream& stream) {
        bool is_closed = false;
        return process(*this, &Server::process_request, stream, is_closed);
    }
};

Library::Library() : server_(std::make_unique<Server>()) {}

Library::~Library() = default;

Message Library::message(const std::string& method, Response answer, const bool closes) const {
    const std::string request = method + " / HTTP/1.1\r\nHost: h\r\n\r\n";
    MemoryStream stream(request);
    Wording mine{std::move(answer), closes, ""};
    wording = &mine;
    try {
        server_->word(stream);
    } catch (...) {  // no memory
        wording = nullptr;
        throw;
    }
    wording = nullptr;
    if (method == "HEAD") return {std::move(stream.written), "", {}};
    return {std::move(stream.written), std::move(mine.body), mine.answer.constant};
}

}  // namespace tuftwave::server
