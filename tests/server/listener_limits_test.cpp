// What a listener does with clients that are slow, too many or too large.
#include <gtest/gtest.h>
#include <netinet/tcp.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "served.hpp"

namespace tuftwave::server::served {
namespace {

ListenerOptions hasty() {
    using namespace std::chrono_literals;
    ListenerOptions hasty = options();
    hasty.patience = {200ms, 200ms, 200ms, 200ms, 200ms, 200ms, 1'000'000'000};
    return hasty;
}

/// Bytes that the system keeps unsent for a client, at most. The server's end of its connection is in this process,
/// too.
std::size_t kept_unsent(const Client& client) {
    sockaddr_in ours{}, peer{};
    socklen_t size = sizeof ours;
    EXPECT_EQ(::getsockname(client.socket(), reinterpret_cast<sockaddr*>(&ours), &size), 0);
    for (int socket = 3; socket < 1'024; ++socket) {
        size = sizeof peer;
        if (::getpeername(socket, reinterpret_cast<sockaddr*>(&peer), &size) != 0) continue;
        if (peer.sin_port != ours.sin_port || peer.sin_addr.s_addr != ours.sin_addr.s_addr) continue;
        unsigned bytes = 0;
        size = sizeof bytes;
        EXPECT_EQ(::getsockopt(socket, IPPROTO_TCP, TCP_NOTSENT_LOWAT, &bytes, &size), 0);
        return bytes;
    }
    ADD_FAILURE() << "nobody serves it";
    return 0;
}

TEST(ListenerLimits, SlowRequestsAreCutOffInTheirTime) {
    const Served served(answering(echo), hasty());
    Client idle(served.port()), slow_head(served.port()), slow_body(served.port());
    slow_head.say("GET /x HT");
    slow_body.say(head("POST /x", "Content-Length: 10\r\n") + "abc");
    EXPECT_EQ(idle.hear_all(), "");
    EXPECT_TRUE(is_problem(slow_head.hear_all(), 408));
    EXPECT_TRUE(is_problem(slow_body.hear_all(), 408));
}

TEST(ListenerLimits, ClientThatDripsGainsNothing) {
    const Served served(answering(echo), hasty());
    Client client(served.port());
    const auto begin = std::chrono::steady_clock::now();
    const std::string request = head("GET /" + std::string(1'000, 'x'));
    for (const char c : request) {
        if (::send(client.socket(), &c, 1, MSG_NOSIGNAL) != 1) break;  // it has been closed
        if (client.has_heard()) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2 * kHangSeconds));
    EXPECT_TRUE(is_problem(client.hear_all(), 408));
}

TEST(ListenerLimits, ClientThatTakesNoAnswerIsLeft) {
    const Served served(answering(echo), hasty());
    const Client client(served.port());
    client.say(head("GET /large"));
    while (served.listener().stats().answer_bytes == 0) std::this_thread::yield();
    while (served.listener().stats().connections != 0) std::this_thread::yield();
    EXPECT_EQ(served.listener().stats().answer_bytes, 0u);
}

TEST(ListenerLimits, TheSystemKeepsAShareOfALargeAnswerThatIsNotTaken) {
    constexpr std::size_t kMebibyte = 1024 * 1024, kMany = 128;
    ListenerOptions wide = options();
    wide.connections = kMany;
    const Served served(answering(echo), wide);
    const auto kept = [&] {
        const Client client(served.port());
        client.say(head("GET /large"));
        while (!client.has_heard()) std::this_thread::yield();
        return kept_unsent(client);
    };
    EXPECT_EQ(kept(), 2 * kMebibyte);
    while (served.listener().stats().connections > 0) std::this_thread::yield();
    std::vector<std::unique_ptr<Client>> others;
    while (others.size() + 1 < kMany) others.push_back(std::make_unique<Client>(served.port()));
    while (served.listener().stats().connections + 1 < kMany) std::this_thread::yield();
    EXPECT_EQ(kept(), 64 * kMebibyte / kMany);
}

TEST(ListenerLimits, OneConnectionTooManyIsToldSo) {
    const Served served;
    std::vector<std::unique_ptr<Client>> clients;
    for (std::size_t i = 0; i < options().connections; ++i) {
        clients.push_back(std::make_unique<Client>(served.port()));
        clients.back()->say(head("GET /x"));
        EXPECT_TRUE(clients.back()->hear().starts_with("HTTP/1.1 200 "));
    }
    EXPECT_TRUE(is_problem(Client(served.port()).hear_all(), 503));
    EXPECT_EQ(served.listener().stats().turned_away, 1u);
    clients.pop_back();
    while (served.listener().stats().connections >= options().connections) std::this_thread::yield();
    EXPECT_TRUE(has(answer(served, head("GET /x")), "GET /x\n"));
}

TEST(ListenerLimits, IdleConnectionsGoSoonerWhereHardlyAnyPlaceIsLeft) {
    using namespace std::chrono_literals;
    ListenerOptions patient = options();
    patient.patience.idle = 2 * kHangSeconds * 1s;
    const Served served(answering(echo), patient);
    std::vector<std::unique_ptr<Client>> clients;  // dealt to all threads
    while (clients.size() < patient.connections) clients.push_back(std::make_unique<Client>(served.port()));
    const auto open = [&] { return served.listener().stats().connections; };
    while (open() < patient.connections) std::this_thread::yield();
    const auto given_up = std::chrono::steady_clock::now() + kHangSeconds * 1s;
    while (open() == patient.connections && std::chrono::steady_clock::now() < given_up)
        std::this_thread::sleep_for(10ms);
    EXPECT_LT(open(), patient.connections);
}

TEST(ListenerLimits, AnswersOverTheirBudgetAreRefused) {
    ListenerOptions small = options();
    small.answer_memory = kLargeAnswer;
    const Served served(answering(echo), small);
    const Client first(served.port());  // alone it may be as large as it likes
    first.say(head("GET /large"));
    while (served.listener().stats().answer_bytes == 0) std::this_thread::yield();
    EXPECT_TRUE(is_problem(answer(served, head("GET /large")), 503));
    EXPECT_TRUE(has(answer(served, head("GET /x")), "GET /x\n"));
}

TEST(ListenerLimits, TheProgramsOwnBytesAreNoMemory) {
    static const std::string page(kLargeAnswer, 'x');
    ListenerOptions small = options();
    small.answer_memory = 1;
    const Served served(answering([](const Request&) { return Response{200, "text/html", "", {}, page}; }), small);
    Client first(served.port()), second(served.port());
    first.say(head("GET /page"));
    while (!first.has_heard()) std::this_thread::yield();
    second.say(head("GET /page"));
    EXPECT_TRUE(second.hear().ends_with("\r\n\r\n" + page));
    EXPECT_LT(served.listener().stats().answer_bytes, 2'000u);
    EXPECT_TRUE(first.hear().ends_with("\r\n\r\n" + page));
}

TEST(ListenerLimits, BodiesOverTheirBudgetAreRefusedAndSmallOnesAreNot) {
    ListenerOptions small = options();
    small.body_memory = 200'000;
    const Served served(answering(echo), small);
    Client first(served.port());
    const std::string most(190'000, 'x');
    first.say(head("POST /x", "Content-Length: 200000\r\n") + most);
    while (served.listener().stats().body_bytes < most.size()) std::this_thread::yield();
    Client second(served.port());
    second.say(head("POST /x", "Content-Length: 200000\r\n") + most);
    EXPECT_TRUE(is_problem(second.hear_all(), 503));
    EXPECT_TRUE(answer(served, post("/x", "small")).ends_with("<small>"));
    first.say(std::string(10'000, 'y'));
    EXPECT_TRUE(first.hear().ends_with("y>"));
    EXPECT_EQ(served.listener().stats().body_bytes, 0u);
}

}  // namespace
}  // namespace tuftwave::server::served
