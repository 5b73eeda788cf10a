#include "http/connection.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <string>

namespace tuftwave::server {
namespace {

using std::chrono::milliseconds;

/// A connection whose other end is in the test's hand.
class Pair {
  public:
    explicit Pair(const ConnectionLimits& limits = {}) : Pair(ends(), limits) {}
    ~Pair() { hang_up(); }
    void say(const std::string& text) const {
        EXPECT_EQ(::send(far_, text.data(), text.size(), 0), static_cast<ssize_t>(text.size()));
    }
    void hang_up() {
        if (far_ >= 0) ::close(far_);
        far_ = -1;
    }
    /// The head's bytes up to its end or a fault.
    std::string head() {
        std::string text;
        while (!text.ends_with("\r\n\r\n")) {
            const int byte = connection.head_byte();
            if (byte < 0) break;
            text += static_cast<char>(byte);
        }
        return text;
    }

  private:
    struct Ends {
        int near = -1, far = -1;
    };
    static Ends ends() {
        int both[2] = {-1, -1};
        EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, both), 0);
        return {both[0], both[1]};
    }
    Pair(const Ends both, const ConnectionLimits& limits) : far_(both.far), connection(both.near, limits, stopping) {}

    int far_;

  public:
    std::atomic<bool> stopping = false;
    Connection connection;
};

ConnectionLimits short_times() {
    ConnectionLimits limits;
    limits.idle = limits.head = limits.body = limits.stall = limits.write = milliseconds(10);
    return limits;
}

TEST(Connection, HeadsComeOneAfterTheOther) {
    Pair pair;
    pair.say("GET /a%20b HTTP/1.1\r\nX: %41\r\n\r\nGET /2 HTTP/1.1\r\n\r\n");
    ASSERT_TRUE(pair.connection.wait_for_request());
    EXPECT_EQ(pair.head(), "GET /a%20b HTTP/1.1\r\nX: %2541\r\n\r\n") << "only header values are made safe";
    ASSERT_TRUE(pair.connection.wait_for_request());
    EXPECT_EQ(pair.head(), "GET /2 HTTP/1.1\r\n\r\n");
    EXPECT_EQ(pair.connection.fault(), 0);
}

TEST(Connection, BodyIsReadUpToTheEnd) {
    Pair pair;
    pair.say("body");
    ASSERT_TRUE(pair.connection.wait_for_request());
    pair.hang_up();
    char bytes[3];
    EXPECT_EQ(pair.connection.read(bytes, 3), 3);
    EXPECT_EQ(pair.connection.read(bytes, 3), 1);
    EXPECT_EQ(pair.connection.read(bytes, 3), 0);
    EXPECT_EQ(pair.connection.fault(), 0);
}

TEST(Connection, ClientThatSaysNothingIsLeft) {
    Pair pair(short_times());
    EXPECT_FALSE(pair.connection.wait_for_request());
}

TEST(Connection, ClientThatHangsUpIsLeft) {
    Pair pair;
    pair.hang_up();
    EXPECT_FALSE(pair.connection.wait_for_request());
}

TEST(Connection, SlowHeadIsAFault) {
    Pair pair(short_times());
    pair.say("GET / HT");
    ASSERT_TRUE(pair.connection.wait_for_request());
    EXPECT_EQ(pair.head(), "GET / HT");
    EXPECT_EQ(pair.connection.fault(), 408);
    EXPECT_TRUE(pair.connection.is_closing());
}

TEST(Connection, SlowBodyIsAFault) {
    Pair pair(short_times());
    pair.say("b");
    ASSERT_TRUE(pair.connection.wait_for_request());
    pair.connection.head_ended();
    char byte = 0;
    EXPECT_EQ(pair.connection.read(&byte, 1), 1);
    EXPECT_EQ(pair.connection.read(&byte, 1), -1);
    EXPECT_EQ(pair.connection.fault(), 408);
}

TEST(Connection, ClientThatDoesNotReadIsGivenUp) {
    Pair pair(short_times());
    EXPECT_FALSE(pair.connection.write(std::string(16 * 1024 * 1024, 'x')));
    EXPECT_TRUE(pair.connection.is_closing());
}

TEST(Connection, LongLinesAndHeadsAreFaults) {
    ConnectionLimits limits;
    limits.line_bytes = 20;
    limits.head_bytes = 50;
    const std::string line = "GET / HTTP/1.1\r\n", header = "X: 123456789\r\n";
    const std::pair<std::string, int> table[] = {
        {line + header + header + "\r\n", 0},
        {line + header + header + header + "\r\n", 431},
        {line + "X: " + std::string(30, 'x'), 431},
        {"GET /" + std::string(30, 'x'), 414},
        {line + "X: a\nb\r\n\r\n", 400},
        {line + "X: a\rb\r\n\r\n", 400},
        {line + std::string(1, '\0') + "\r\n\r\n", 400},
    };
    for (const auto& [text, fault] : table) {
        Pair pair(limits);
        pair.say(text);
        ASSERT_TRUE(pair.connection.wait_for_request());
        pair.head();
        EXPECT_EQ(pair.connection.fault(), fault) << text;
    }
}

TEST(Connection, StoppingLeavesAnIdleClientAndServesOneThatHasSpoken) {
    Pair idle;
    idle.stopping = true;
    EXPECT_FALSE(idle.connection.wait_for_request());
    Pair speaking;
    speaking.stopping = true;
    speaking.say("GET / HTTP/1.1\r\n\r\n");
    EXPECT_TRUE(speaking.connection.wait_for_request());
    EXPECT_EQ(speaking.head(), "GET / HTTP/1.1\r\n\r\n");
    EXPECT_TRUE(speaking.connection.is_closing());
}

}  // namespace
}  // namespace tuftwave::server
