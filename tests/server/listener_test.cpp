#include "http/listener.hpp"

#include <gtest/gtest.h>

#include <latch>
#include <string>
#include <thread>
#include <variant>

#include "served.hpp"

namespace tuftwave::server::served {
namespace {

TEST(Listener, RequestArrivesDecodedAndInOrder) {
    const Served served;
    const std::string text = answer(served, post("/a%20b?z=1&a=%C3%A9+x&z=2&flag", "body", "X-Odd-NAME: v%0D%0A\r\n"));
    EXPECT_TRUE(has(text, "POST /a b\n?z=1\n?a=\xC3\xA9 x\n?z=2\n?flag=\n")) << text;
    EXPECT_TRUE(has(text, "x-odd-name: v%0D%0A\n")) << "header values are not decoded: " << text;
    EXPECT_FALSE(has(text, "remote_addr")) << text;
    EXPECT_TRUE(text.ends_with("<body>")) << text;
    EXPECT_TRUE(has(text, "X-Content-Type-Options: nosniff\r\n"));
    EXPECT_FALSE(has(text, "\r\nServer:"));
}

TEST(Listener, ErrorsOfTheHandlerPassThrough) {
    const Served served;
    const std::string text = answer(served, head("GET /missing"));
    EXPECT_TRUE(text.starts_with("HTTP/1.1 404 ")) << text;
    EXPECT_TRUE(has(text, "X-Mine: 1\r\n")) << text;
    EXPECT_TRUE(text.ends_with("mine")) << text;
}

TEST(Listener, HeadHasTheHeadersOfGetAndNoBody) {
    const Served served;
    Client client(served.port());
    client.say(head("HEAD /json") + head("GET /x"));
    EXPECT_TRUE(has(client.hear(false), "Content-Length: 5000\r\n"));
    EXPECT_TRUE(client.hear().starts_with("HTTP/1.1 200 ")) << "the next answer follows at once";
}

TEST(Listener, RefusedHeadHasNoBodyEither) {
    const Served served;
    Client client(served.port());
    client.say(head("HEAD /x", "Content-Length: 1\r\n") + "x");
    const std::string text = client.hear_all();
    EXPECT_TRUE(text.starts_with("HTTP/1.1 400 ")) << text;
    EXPECT_TRUE(text.ends_with("\r\n\r\n")) << text;
}

TEST(Listener, NoContentHasNoLength) {
    const Served served;
    EXPECT_FALSE(has(answer(served, head("GET /nothing")), "Content-Length"));
}

TEST(Listener, TwoRequestsInOneConnectionAreBothAnswered) {
    const Served served;
    Client client(served.port());
    client.say(post("/1", "one"));
    EXPECT_TRUE(client.hear().ends_with("<one>"));
    client.say(post("/2", "two") + post("/3", "three"));  // and two in one packet
    EXPECT_TRUE(client.hear().ends_with("<two>"));
    EXPECT_TRUE(client.hear().ends_with("<three>"));
}

TEST(Listener, ManyRequestsInOnePacketAreAllAnswered) {
    const Served served;
    Client client(served.port());
    client.say(repeated(head("GET /x"), 100));
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(client.hear().starts_with("HTTP/1.1 200 ")) << i;
}

TEST(Listener, SecondListenerOnThePortFails) {
    const Served served;
    ListenerOptions same = options();
    same.port = served.port();
    Listener second(same, answering(echo));
    const auto bound = second.bind();
    const std::string* error = std::get_if<std::string>(&bound);
    ASSERT_TRUE(error);
    EXPECT_TRUE(has(*error, "127.0.0.1:" + std::to_string(served.port()))) << *error;
    EXPECT_TRUE(has(*error, "in use")) << *error;
}

TEST(Listener, AddressThatIsNotOursIsAnError) {
    ListenerOptions foreign = options();
    foreign.host = "192.0.2.1";  // kept for documentation, nobody has it
    EXPECT_TRUE(std::holds_alternative<std::string>(Listener(foreign, answering(echo)).bind()));
}

TEST(Listener, AnswerIsNotCompressedButTheHandlerMayKnow) {
    const Served served;
    const std::string text = answer(served, head("GET /json", "Accept-Encoding: br, gzip\r\n"));
    EXPECT_FALSE(has(text, "Content-Encoding")) << text;
    EXPECT_TRUE(has(text, "Content-Length: 5000\r\n")) << text;
    EXPECT_TRUE(has(answer(served, head("GET /x", "Accept-Encoding: br, gzip\r\n")), "\naccept-encoding: br, gzip\n"));
}

TEST(Listener, RangeIsIgnored) {
    const Served served;
    for (const char* range : {"bytes=0-1", "bytes=0-1,3-4,0-0", "bytes=9999-", "what"}) {
        const std::string text = answer(served, head("GET /json", std::string("Range: ") + range + "\r\n"));
        EXPECT_TRUE(text.starts_with("HTTP/1.1 200 ")) << text;
        EXPECT_TRUE(has(text, "Content-Length: 5000\r\n")) << text;
    }
}

TEST(Listener, BodyOfExactlyTheLimitIsTaken) {
    const Served served;
    const std::string body(kBodyLimit, 'x');
    EXPECT_TRUE(answer(served, post("/x", body)).ends_with("<" + body + ">"));
}

TEST(Listener, BodyOverTheLimitIsRefusedBeforeItIsSent) {
    const Served served;
    Client client(served.port());
    client.say(head("POST /x", "Content-Length: 1000000000000\r\n"));
    const std::string text = client.hear_all();
    EXPECT_TRUE(is_problem(text, 413)) << text;
    EXPECT_TRUE(has(text, "Connection: close\r\n"));
}

TEST(Listener, ClientThatSendsAllItsBodyStillHearsWhyItIsRefused) {
    const Served served;
    Client client(served.port());
    client.say(post("/x", std::string(8 * kBodyLimit, 'x')));
    EXPECT_TRUE(is_problem(client.hear_all(), 413));
}

TEST(Listener, ChunkedBodyIsTakenWithinTheLimitAndRefusedOverIt) {
    const Served served;
    Client client(served.port());
    const std::string chunked = head("POST /x", "Transfer-Encoding: chunked\r\n");
    client.say(chunked + "3\r\nabc\r\n2;extension=1\r\nde\r\n0\r\nTrailer: 1\r\n\r\n");
    EXPECT_TRUE(client.hear().ends_with("<abcde>"));
    const std::string half(kBodyLimit / 2, 'x');  // 0x7a120 = 500,000
    client.say(chunked + "7a120\r\n" + half + "\r\n7a121\r\n");
    EXPECT_TRUE(is_problem(client.hear_all(), 413));
}

TEST(Listener, RequestThatIsAnsweredOnItsHeadKeepsTheConnectionIfAllOfItHasCome) {
    const Served served;
    const std::string smuggled = "GET /smuggled HTTP/1.1\r\nHost: h\r\n\r\n";
    Client client(served.port());
    client.say(head("GET /early") + post("/early", smuggled) + post("/x", "next"));
    EXPECT_TRUE(is_problem(client.hear(), 404));
    EXPECT_TRUE(is_problem(client.hear(), 404));
    EXPECT_TRUE(client.hear().ends_with("<next>")) << "and no body is the next request";
}

TEST(Listener, RequestThatIsAnsweredOnItsHeadEndsTheConnectionIfItsBodyIsStillToCome) {
    const Served served;
    const std::string length = "Content-Length: 100\r\n", chunked = "Transfer-Encoding: chunked\r\n";
    for (const std::string& body : {length + "\r\nhalf of it", chunked + "\r\n0\r\n\r\n"}) {
        Client client(served.port());
        client.say("POST /early HTTP/1.1\r\nHost: h\r\n" + body);
        const std::string text = client.hear_all();
        EXPECT_TRUE(is_problem(text, 404)) << text;
        EXPECT_TRUE(has(text, "Connection: close\r\n")) << text;
    }
}

TEST(Listener, FormAndMultipartBodiesArePlainBytes) {
    const Served served;
    const std::string form =
        answer(served, post("/x", "a=1&b=%20", "Content-Type: application/x-www-form-urlencoded\r\n"));
    EXPECT_TRUE(form.ends_with("<a=1&b=%20>")) << form;
    const std::string parts = "--b\r\nContent-Disposition: form-data; name=\"f\"\r\n\r\nv\r\n--b--\r\n";
    const std::string multipart =
        answer(served, post("/x", parts, "Content-Type: multipart/form-data; boundary=b\r\n"));
    EXPECT_TRUE(multipart.ends_with("<" + parts + ">")) << multipart;
}

TEST(Listener, ExceptionIsAProblemWithoutItsText) {
    const Served served;
    const std::string text = answer(served, head("GET /throw"));
    EXPECT_TRUE(is_problem(text, 500)) << text;
    EXPECT_FALSE(has(text, "secret")) << text;
    EXPECT_FALSE(has(text, "EXCEPTION")) << text;
}

struct Doubtful {
    const char* name;
    std::string request;
    int status;
};

// Where two readers could disagree on what belongs to which request, and where memory or time would be for the taking.
TEST(Listener, DoubtfulRequestsAreRefusedAndTheConnectionCloses) {
    const Served served;
    const std::string smuggled = head("GET /smuggled");
    const std::vector<Doubtful> table{
        {"unknown method", head("BREW /x"), 501},
        {"unknown version", "GET /x HTTP/3.0\r\n", 505},
        {"expects the impossible", head("POST /x", "Content-Length: 4\r\nExpect: more\r\n") + smuggled, 417},
        {"no length", head("POST /x"), 411},
        {"length and chunked", head("POST /x", "Content-Length: 4\r\nTransfer-Encoding: chunked\r\n") + smuggled, 400},
        {"two lengths", head("POST /x", "Content-Length: 4\r\nContent-Length: 4\r\n") + smuggled, 400},
        {"length that is no number", head("POST /x", "Content-Length: 3xyz\r\n") + smuggled, 400},
        {"encoded length", head("POST /x", "Content-Length: %33\r\n") + smuggled, 400},
        {"unknown transfer encoding", head("POST /x", "Transfer-Encoding: gzip, chunked\r\n") + smuggled, 400},
        {"encoded transfer encoding", head("POST /x", "Transfer-Encoding: %63hunked\r\n") + smuggled, 400},
        {"space before the colon", head("POST /x", "Content-Length: 0\r\nTransfer-Encoding : chunked\r\n") + smuggled,
         400},
        {"GET with a body", head("GET /x", "Content-Length: 28\r\n") + smuggled, 400},
        {"chunk that is longer than said", head("POST /x", "Transfer-Encoding: chunked\r\n") + "1\r\nab\r\n0\r\n\r\n",
         400},
        {"chunk length that is no number", head("POST /x", "Transfer-Encoding: chunked\r\n") + "-1\r\nab\r\n0\r\n\r\n",
         400},
        {"packed body", head("POST /x", "Content-Length: 4\r\nContent-Encoding: gzip\r\n") + smuggled, 415},
        {"no host", "GET /x HTTP/1.1\r\n\r\n" + smuggled, 400},
        {"two hosts", head("GET /x", "Host: other\r\n") + smuggled, 400},
        {"line feed alone", "GET /x HTTP/1.1\r\nHost: h\nX: y\r\n\r\n" + smuggled, 400},
        {"target that is no path", head("GET http://h/x") + smuggled, 400},
        {"badly encoded target", head("GET /%zz") + smuggled, 400},
        {"not HTTP", "hello\r\n\r\n", 400},
        {"long target", head("GET /" + std::string(9'000, 'x')), 414},
        {"target without end", "GET /" + std::string(9'000, 'x'), 414},
        {"long header", head("GET /x", "X: " + std::string(17'000, 'x') + "\r\n"), 431},
        {"65 headers", head("GET /x", repeated("X: 1\r\n", 64)), 431},  // with Host
        {"large headers", head("GET /x", repeated("X: " + std::string(1'000, 'x') + "\r\n", 20)), 431},
    };
    for (const Doubtful& row : table) {
        Client client(served.port());
        client.say(row.request);
        const std::string text = client.hear_all();
        EXPECT_TRUE(is_problem(text, row.status)) << row.name << ": " << text;
        EXPECT_TRUE(has(text, "Connection: close\r\n")) << row.name << ": " << text;
    }
}

TEST(Listener, AsManyHeadersAsAreAllowedAreTaken) {
    const Served served;
    EXPECT_TRUE(answer(served, head("GET /x", repeated("X: 1\r\n", 63))).starts_with("HTTP/1.1 200 "));
}

TEST(Listener, ClientThatAsksBeforeItSendsIsToldEarly) {
    const Served served;
    Client client(served.port());
    client.say(head("POST /x", "Expect: 100-continue\r\nContent-Length: 2\r\n"));
    EXPECT_EQ(client.hear(), "HTTP/1.1 100 Continue\r\n\r\n");
    client.say("ab");
    EXPECT_TRUE(client.hear().ends_with("<ab>"));
    Client large(served.port());
    large.say(head("POST /x", "Expect: 100-continue\r\nContent-Length: 2000000\r\n"));
    EXPECT_TRUE(is_problem(large.hear_all(), 413));
}

TEST(Listener, OldClientsAreAnsweredAndLeft) {
    const Served served;
    Client client(served.port());
    client.say("GET /x HTTP/1.0\r\n\r\n");
    EXPECT_TRUE(client.hear_all().starts_with("HTTP/1.1 200 "));
}

TEST(Listener, DrainingAnswersSayCloseAndNewConnectionsAreServed) {
    Served served;
    Client kept(served.port());
    kept.say(head("GET /1"));
    EXPECT_FALSE(has(kept.hear(), "Connection: close"));
    served.listener().drain();
    kept.say(head("GET /2"));
    EXPECT_TRUE(has(kept.hear_all(), "Connection: close\r\n"));
    EXPECT_TRUE(has(answer(served, head("GET /3")), "GET /3\n"));
}

TEST(Listener, StopClosesIdleConnections) {
    Served served;
    Client used(served.port()), fresh(served.port());
    used.say(head("GET /x"));
    used.hear();
    served.stop();
    EXPECT_EQ(used.hear_all(), "");
    EXPECT_EQ(fresh.hear_all(), "");
}

/// An answerer that keeps every request until it is told to answer.
struct Later {
    std::latch begun{1};
    std::stop_token stop;
    Reply reply;
    Answerer answerer() {
        Answerer made = answering(echo);
        made.admit = [this](const Request&, bool) {
            return Admission{kBodyLimit,
                             [this](const Request&, const std::stop_source& source, const Reply& its_reply) {
                                 stop = source.get_token();
                                 reply = its_reply;
                                 begun.count_down();
                             }};
        };
        return made;
    }
};

TEST(Listener, StopLetsARunningRequestEnd) {
    Later later;
    Served served(later.answerer());
    Client client(served.port());
    client.say(head("GET /slow"));
    later.begun.wait();
    served.listener().stop();
    later.reply({200, "text/plain", "at last", {}});
    const std::string text = client.hear_all();
    EXPECT_TRUE(text.ends_with("at last")) << text;
    EXPECT_TRUE(has(text, "Connection: close\r\n")) << text;
}

TEST(Listener, WorkForAClientThatHasGoneIsAskedToStop) {
    Later later;
    Served served(later.answerer());
    {
        const Client client(served.port());
        client.say(head("GET /slow"));
        later.begun.wait();
    }
    while (!later.stop.stop_requested()) std::this_thread::yield();
    EXPECT_EQ(served.listener().stats().connections, 1u) << "its place is kept until its work has ended";
    later.reply({200, "text/plain", "for nobody", {}});
    while (served.listener().stats().connections != 0) std::this_thread::yield();
}

TEST(Listener, RequestThatNobodyAnswersIsClosed) {
    Later later;
    Served served(later.answerer());
    Client client(served.port());
    client.say(head("GET /slow"));
    later.begun.wait();
    later.reply = nullptr;
    EXPECT_EQ(client.hear_all(), "");
}

TEST(Listener, AsManyConnectionsAsThreadsAreServedAtOnce) {
    std::latch all(options().threads);
    const Served served(answering([&](const Request&) -> Response {
        all.arrive_and_wait();
        return {200, "text/plain", "both", {}};
    }));
    Client one(served.port()), other(served.port());
    one.say(head("GET /x"));
    other.say(head("GET /x"));
    EXPECT_TRUE(one.hear().ends_with("both"));
    EXPECT_TRUE(other.hear().ends_with("both"));
}

TEST(Listener, StopBeforeServingIsNotForgotten) {
    Listener listener(options(), answering(echo));
    ASSERT_TRUE(std::holds_alternative<int>(listener.bind()));
    listener.stop();
    listener.serve();
}

}  // namespace
}  // namespace tuftwave::server::served
