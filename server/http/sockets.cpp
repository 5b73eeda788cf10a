#include "http/sockets.hpp"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <system_error>

namespace tuftwave::server {
namespace {

constexpr int kBacklog = 1'024;  // with the usual 5 a burst of connections would wait a second and more

/// @return  nothing, with errno, if it cannot be had
Descriptor listening_on(const addrinfo& address) {
    const int yes = 1, no = 0;
    Descriptor socket(::socket(address.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, address.ai_protocol));
    if (!socket.is_open()) return socket;
    // A port can be taken again while old connections linger, but never, as with SO_REUSEPORT, shared with a forgotten
    // server that then silently takes half of the requests.
    ::setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    ::setsockopt(socket.number(), IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);  // accepted sockets inherit it
    if (address.ai_family == AF_INET6) ::setsockopt(socket.number(), IPPROTO_IPV6, IPV6_V6ONLY, &no, sizeof no);
    if (::bind(socket.number(), address.ai_addr, address.ai_addrlen) != 0 || ::listen(socket.number(), kBacklog) != 0) {
        const int reason = errno;
        socket.close();
        errno = reason;
    }
    return socket;
}

}  // namespace

void Descriptor::close() {
    if (is_open()) ::close(number_);
    number_ = -1;
}

std::variant<Descriptor, std::string> listen_on(const std::string& host, const int port) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_PASSIVE;
    addrinfo* found = nullptr;
    errno = 0;
    std::string reason = "no such address";
    if (::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) == 0) {
        const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> addresses(found, &::freeaddrinfo);
        for (const addrinfo* address = found; address; address = address->ai_next) {
            Descriptor socket = listening_on(*address);
            if (socket.is_open()) return socket;
            reason = std::generic_category().message(errno);
        }
    }
    return "cannot listen on " + host + ":" + std::to_string(port) + ": " + reason;
}

void keep_unsent(const int socket, const std::size_t most) {
    const auto bytes = static_cast<unsigned>(most);
    ::setsockopt(socket, IPPROTO_TCP, TCP_NOTSENT_LOWAT, &bytes, sizeof bytes);
}

int port_of(const Descriptor& socket) {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    if (::getsockname(socket.number(), reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
    return ntohs(address.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6&>(address).sin6_port
                                               : reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

Accepted accept_from(const Descriptor& listening) {
    for (;;) {
        const int socket = ::accept4(listening.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (socket >= 0) return {Descriptor(socket), false};
        if (errno == EINTR || errno == ECONNABORTED) continue;
        return {Descriptor(), errno != EAGAIN && errno != EWOULDBLOCK};
    }
}

}  // namespace tuftwave::server
