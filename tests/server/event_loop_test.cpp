#include "http/event_loop.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>
#include <string>
#include <thread>

#include "served.hpp"

namespace tuftwave::server::served {
namespace {

/// Both ends of a connection without a port.
struct Pair {
    Pair() {
        std::array<int, 2> ends{-1, -1};
        EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()), 0);
        ours = Descriptor(ends[0]);
        theirs = Descriptor(ends[1]);
    }
    void say(const std::string& text) const {
        EXPECT_EQ(::send(theirs.number(), text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
    }
    /// Until the other side closes.
    std::string hear_all() const {
        std::string text;
        std::array<char, 4'096> buffer;
        for (ssize_t got; (got = ::recv(theirs.number(), buffer.data(), buffer.size(), 0)) > 0;)
            text.append(buffer.data(), static_cast<std::size_t>(got));
        return text;
    }
    Descriptor ours, theirs;
};

TEST(EventLoop, WhoWasTakenInIsCountedAndServedUntilItGoes) {
    Premises premises(options(), answering(echo));
    EventLoop loop(premises);
    Pair pair;
    loop.take_in(std::move(pair.ours), false);
    EXPECT_EQ(premises.connections, 1u) << "before it is served";
    pair.say(head("GET /here", "Connection: close\r\n"));
    std::thread thread([&] { loop.serve(); });
    EXPECT_TRUE(has(pair.hear_all(), "GET /here\n"));
    pair.theirs.close();
    loop.finish();
    thread.join();
    EXPECT_EQ(premises.connections, 0u);
    EXPECT_EQ(premises.answer_bytes, 0u);
}

TEST(EventLoop, OneTooManyHearsSo) {
    Premises premises(options(), answering(echo));
    EventLoop loop(premises);
    Pair pair;
    loop.take_in(std::move(pair.ours), true);
    std::thread thread([&] { loop.serve(); });
    EXPECT_TRUE(is_problem(pair.hear_all(), 503));
    pair.theirs.close();
    loop.finish();
    thread.join();
}

TEST(EventLoop, ConnectionThatCannotBeWaitedForIsNotCounted) {
    Premises premises(options(), answering(echo));
    EventLoop loop(premises);
    loop.take_in(Descriptor(::open("/dev/null", O_RDONLY | O_CLOEXEC)), false);  // epoll refuses it
    loop.finish();
    loop.serve();
    EXPECT_EQ(premises.connections, 0u);
}

}  // namespace
}  // namespace tuftwave::server::served
