#include "http/healthcheck.hpp"

#include <netdb.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <memory>
#include <string_view>

namespace tuftwave::server {
namespace {

constexpr timeval kPatience{3, 0};
constexpr std::string_view kAnswer = "HTTP/1.1 200";  // what is needed of an answer

/// @return  a connected socket, or -1
int connected(const std::string& host, const int port) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) return -1;
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> addresses(found, &::freeaddrinfo);
    for (const addrinfo* address = found; address; address = address->ai_next) {
        const int socket = ::socket(address->ai_family, address->ai_socktype | SOCK_CLOEXEC, address->ai_protocol);
        if (socket < 0) continue;
        ::setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &kPatience, sizeof kPatience);  // also that of connect()
        ::setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &kPatience, sizeof kPatience);
        if (::connect(socket, address->ai_addr, address->ai_addrlen) == 0) return socket;
        ::close(socket);
    }
    return -1;
}

}  // namespace

int http_status(const std::string& host, const int port, const std::string& path) {
    const int socket = connected(host, port);
    if (socket < 0) return 0;
    const std::string request = "GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n\r\n";
    std::array<char, kAnswer.size()> answer{};
    std::size_t heard = 0;
    if (::send(socket, request.data(), request.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(request.size())) {
        for (ssize_t got;
             heard < answer.size() && (got = ::recv(socket, answer.data() + heard, answer.size() - heard, 0)) > 0;)
            heard += static_cast<std::size_t>(got);
    }
    ::close(socket);
    int status = 0;
    if (heard != answer.size() || !std::string_view(answer.data(), heard).starts_with("HTTP/1.")) return 0;
    std::from_chars(answer.data() + heard - 3, answer.data() + heard, status);
    return status;
}

}  // namespace tuftwave::server
