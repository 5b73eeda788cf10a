#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdint>
#include <string>
#include <utility>

namespace tuftwave::server {

constexpr int kHangSeconds = 20;  // no answer by then is a failure, not a wait

/// A socket that says and hears plain text.
class Client {
  public:
    explicit Client(const int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        const timeval patience{kHangSeconds, 0};
        ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
        EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    }
    ~Client() { ::close(socket_); }

    void say(const std::string& text) const {
        EXPECT_EQ(::send(socket_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
    }

    int socket() const { return socket_; }

    /// Whether something has come, or the end.
    bool has_heard() const {
        char byte;
        return ::recv(socket_, &byte, 1, MSG_PEEK | MSG_DONTWAIT) >= 0;
    }

    /// One answer: its head, and the body that Content-Length announces. @param has_body  false after HEAD
    std::string hear(const bool has_body = true) {
        while (heard_.find("\r\n\r\n") == std::string::npos && more()) {
        }
        const std::size_t head = heard_.find("\r\n\r\n") + 4;
        const std::size_t length = heard_.find("Content-Length: ");
        const std::size_t body = has_body && length < head ? std::stoul(heard_.substr(length + 16)) : 0;
        while (heard_.size() < head + body && more()) {
        }
        const std::string answer = heard_.substr(0, head + body);
        heard_.erase(0, answer.size());
        return answer;
    }

    /// Everything until the server closes.
    std::string hear_all() {
        while (more()) {
        }
        return std::exchange(heard_, "");
    }

  private:
    bool more() {
        char buffer[4096];
        const ssize_t got = ::recv(socket_, buffer, sizeof buffer, 0);
        if (got > 0) heard_.append(buffer, static_cast<std::size_t>(got));
        return got > 0;
    }

    const int socket_;
    std::string heard_;
};

}  // namespace tuftwave::server
