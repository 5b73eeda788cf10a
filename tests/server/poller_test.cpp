#include "http/poller.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <thread>
#include <vector>

namespace tuftwave::server {
namespace {

using namespace std::chrono_literals;

/// Two sockets that talk to each other.
struct Pair {
    Descriptor mine, theirs;
    Pair() {
        std::array<int, 2> numbers{};
        EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, numbers.data()), 0);
        mine = Descriptor(numbers[0]);
        theirs = Descriptor(numbers[1]);
    }
};

std::vector<Event> events(Poller& poller, const std::chrono::milliseconds patience = 0ms) {
    std::vector<Event> all;
    poller.wait(patience, [&](const Event& event) { all.push_back(event); });
    return all;
}

TEST(Poller, TellsWhatASocketWaitsFor) {
    Poller poller;
    Pair pair;
    ASSERT_TRUE(poller.add(pair.mine.number(), 7, {true, false, true}));
    EXPECT_TRUE(events(poller).empty());
    EXPECT_EQ(::write(pair.theirs.number(), "x", 1), 1);
    ASSERT_EQ(events(poller).size(), 1u);
    EXPECT_EQ(events(poller)[0].id, 7u);
    EXPECT_TRUE(events(poller)[0].can_read);
    EXPECT_FALSE(events(poller)[0].has_peer_closed);
    poller.change(pair.mine.number(), 7, {false, true, false});
    EXPECT_TRUE(events(poller)[0].can_write);
    EXPECT_FALSE(events(poller)[0].can_read);
}

TEST(Poller, TellsOfTheEndToWhoWantsToSeeIt) {
    Poller poller;
    Pair pair;
    ASSERT_TRUE(poller.add(pair.mine.number(), 7, {false, false, false}));
    ::shutdown(pair.theirs.number(), SHUT_WR);
    EXPECT_TRUE(events(poller).empty());
    poller.change(pair.mine.number(), 7, {false, false, true});
    EXPECT_TRUE(events(poller)[0].has_peer_closed);
    EXPECT_FALSE(events(poller)[0].is_broken);
    pair.theirs.close();
    EXPECT_TRUE(events(poller)[0].is_broken);
}

TEST(Poller, IsWokenByAnotherThreadAndOnlyOnce) {
    Poller poller;
    std::thread other([&] { poller.wake(); });
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE(events(poller, 20s).empty());
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s);
    other.join();
    EXPECT_TRUE(events(poller, 1ms).empty());
}

}  // namespace
}  // namespace tuftwave::server
