#include "http/sockets.hpp"

#include <gtest/gtest.h>
#include <netinet/tcp.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include "client.hpp"

namespace tuftwave::server {
namespace {

Descriptor listening() {
    auto made = listen_on("127.0.0.1", 0);
    EXPECT_TRUE(std::holds_alternative<Descriptor>(made));
    return std::move(std::get<Descriptor>(made));
}

int option(const Descriptor& socket, const int level, const int name) {
    int value = 0;
    socklen_t size = sizeof value;
    EXPECT_EQ(::getsockopt(socket.number(), level, name, &value, &size), 0);
    return value;
}

TEST(Sockets, PortIsOursAlone) {
    const Descriptor socket = listening();
    EXPECT_GT(port_of(socket), 0);
    EXPECT_EQ(option(socket, SOL_SOCKET, SO_REUSEADDR), 1);
    EXPECT_EQ(option(socket, SOL_SOCKET, SO_REUSEPORT), 0);
    const auto second = listen_on("127.0.0.1", port_of(socket));
    ASSERT_TRUE(std::holds_alternative<std::string>(second));
    EXPECT_NE(std::get<std::string>(second).find("in use"), std::string::npos);
}

TEST(Sockets, BothKindsOfAddressesAndNothingElse) {
    const auto ipv6 = listen_on("::1", 0);
    if (const auto* socket = std::get_if<Descriptor>(&ipv6)) {
        EXPECT_GT(port_of(*socket), 0);  // a machine may have no IPv6
    }
    for (const char* host : {"192.0.2.1", "no such host"})
        EXPECT_TRUE(std::holds_alternative<std::string>(listen_on(host, 0))) << host;
}

TEST(Sockets, AcceptingDoesNotWait) {
    const Descriptor socket = listening();
    const Accepted nobody = accept_from(socket);
    EXPECT_FALSE(nobody.socket.is_open());
    EXPECT_FALSE(nobody.out_of_descriptors);
    const Client client(port_of(socket));
    const Accepted accepted = accept_from(socket);
    ASSERT_TRUE(accepted.socket.is_open());
    char byte;
    EXPECT_EQ(::recv(accepted.socket.number(), &byte, 1, 0), -1) << "it does not block";
    EXPECT_EQ(option(accepted.socket, IPPROTO_TCP, TCP_NODELAY), 1);
}

TEST(Sockets, TheSystemKeepsLittleOfWhatASlowClientLeaves) {
    constexpr std::size_t kAnswer = 8 * 1024 * 1024;
    const std::string answer(kAnswer, 'x');
    const Descriptor socket = listening();
    const auto taken = [&](const std::size_t most) {
        const Client client(port_of(socket));
        const Accepted accepted = accept_from(socket);
        keep_unsent(accepted.socket.number(), most);
        EXPECT_EQ(option(accepted.socket, IPPROTO_TCP, TCP_NOTSENT_LOWAT), static_cast<int>(most));
        return ::send(accepted.socket.number(), answer.data(), answer.size(), MSG_NOSIGNAL);
    };
    const ssize_t little = taken(64 * 1024), more = taken(2 * 1024 * 1024);
    EXPECT_GT(little, 0);
    EXPECT_GE(more, little + 1024 * 1024);
    EXPECT_LT(more, static_cast<ssize_t>(kAnswer));
}

TEST(Sockets, KnowsWhenThereAreNoDescriptorsLeft) {
    const Descriptor socket = listening();
    const Client client(port_of(socket));
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
    rlimit none = before;
    none.rlim_cur = 0;
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
    const Accepted refused = accept_from(socket);
    ::setrlimit(RLIMIT_NOFILE, &before);
    EXPECT_FALSE(refused.socket.is_open());
    EXPECT_TRUE(refused.out_of_descriptors);
    EXPECT_TRUE(accept_from(socket).socket.is_open());
}

TEST(Descriptor, IsClosedWithItsOwner) {
    Descriptor first = listening();
    const int number = first.number();
    Descriptor second = std::move(first);
    EXPECT_FALSE(first.is_open());
    EXPECT_EQ(second.number(), number);
    second.close();
    EXPECT_FALSE(second.is_open());
}

}  // namespace
}  // namespace tuftwave::server
