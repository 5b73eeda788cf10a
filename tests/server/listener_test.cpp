#include "http/listener.hpp"

#include <gtest/gtest.h>

#include <latch>
#include <stdexcept>
#include <string>
#include <thread>
#include <variant>

#include "client.hpp"

namespace tuftwave::server {
namespace {

constexpr std::size_t kBodyLimit = 1'000;

/// Says what it was asked, in a form that the tests can look into.
Response echo(const Request& request) {
    if (request.path == "/throw") throw std::runtime_error("secret");
    if (request.path == "/missing") return {404, "application/problem+json", "mine", {{"X-Mine", "1"}}};
    if (request.path == "/nothing") return {204, "", "", {}};
    if (request.path == "/json") return {200, "application/json", std::string(5'000, ' '), {}};
    std::string text = request.method + " " + request.path + "\n";
    for (const auto& [name, value] : request.query) text += "?" + name + "=" + value + "\n";
    for (const auto& [name, value] : request.headers) text += name + ": " + value + "\n";
    return {200, "text/plain", text + "<" + request.body + ">", {}};
}

Response problem(const int status) {
    return {status, "application/problem+json", "problem " + std::to_string(status), {}};
}

/// A listener on a free port, with a thread that serves.
class Served {
  public:
    explicit Served(Listener::Handle handle = echo) : listener_(options(), std::move(handle), problem) {
        const auto bound = listener_.bind();
        if (const auto* error = std::get_if<std::string>(&bound)) ADD_FAILURE() << *error;
        if (const int* port = std::get_if<int>(&bound)) port_ = *port;
        thread_ = std::thread([this] { ended_well_ = listener_.serve(); });
    }
    ~Served() { stop(); }
    void stop() {
        listener_.stop();
        if (!thread_.joinable()) return;
        thread_.join();
        EXPECT_TRUE(ended_well_);
    }
    int port() const { return port_; }
    Listener& listener() { return listener_; }

    static ListenerOptions options() {
        return {"127.0.0.1", 0, 8, [](const std::string&) { return kBodyLimit; }};
    }

  private:
    Listener listener_;
    int port_ = 0;
    bool ended_well_ = false;
    std::thread thread_;
};

std::string head(const std::string& first_line, const std::string& more = "") {
    return first_line + " HTTP/1.1\r\nHost: h\r\n" + more + "\r\n";
}

std::string post(const std::string& path, const std::string& body, const std::string& more = "") {
    return head("POST " + path, more + "Content-Length: " + std::to_string(body.size()) + "\r\n") + body;
}

std::string repeated(const std::string& text, const int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// What a fresh connection answers.
std::string answer(const Served& served, const std::string& request) {
    Client client(served.port());
    client.say(request);
    return client.hear();
}

bool is_problem(const std::string& text, const int status) {
    const std::string code = std::to_string(status);
    return text.starts_with("HTTP/1.1 " + code + " ") && text.ends_with("\r\n\r\nproblem " + code) &&
           has(text, "Content-Type: application/problem+json\r\n") && has(text, "X-Content-Type-Options: nosniff\r\n");
}

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

TEST(Listener, EveryMethodReachesTheHandler) {
    const Served served;
    for (const char* method : {"GET", "OPTIONS", "DELETE", "TRACE"})
        EXPECT_TRUE(has(answer(served, head(std::string(method) + " /x")), std::string(method) + " /x\n")) << method;
    for (const char* method : {"POST", "PUT", "PATCH"})
        EXPECT_TRUE(answer(served, head(std::string(method) + " /x", "Content-Length: 1\r\n") + "b").ends_with("<b>"))
            << method;
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
    const std::string text = client.hear(false);
    EXPECT_TRUE(has(text, "Content-Length: 5000\r\n")) << text;
    EXPECT_FALSE(has(text, "Accept-Ranges")) << text;
    EXPECT_TRUE(client.hear().starts_with("HTTP/1.1 200 ")) << "the next answer follows at once";
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

TEST(Listener, SecondListenerOnThePortFails) {
    const Served served;
    ListenerOptions options = Served::options();
    options.port = served.port();
    Listener second(options, echo, problem);
    const auto bound = second.bind();
    const std::string* error = std::get_if<std::string>(&bound);
    ASSERT_TRUE(error);
    EXPECT_TRUE(has(*error, "127.0.0.1:" + std::to_string(served.port()))) << *error;
    EXPECT_TRUE(has(*error, "in use")) << *error;
}

TEST(Listener, AddressThatIsNotOursIsAnError) {
    ListenerOptions options = Served::options();
    options.host = "192.0.2.1";  // kept for documentation, nobody has it
    EXPECT_TRUE(std::holds_alternative<std::string>(Listener(options, echo, problem).bind()));
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
    for (const char* range : {"bytes=0-1", "bytes=0-1,3-4,0-0", "bytes=9999-"}) {
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

TEST(Listener, BodyOverTheLimitIsAProblemAndTheConnectionStays) {
    const Served served;
    Client client(served.port());
    client.say(post("/x", std::string(kBodyLimit + 1, 'x')));
    EXPECT_TRUE(is_problem(client.hear(), 413));
    client.say(post("/x", "small"));
    EXPECT_TRUE(client.hear().ends_with("<small>"));
}

TEST(Listener, HugeBodyIsRefusedBeforeItIsSent) {
    const Served served;
    Client client(served.port());
    client.say(head("POST /x", "Content-Length: 1000000000000\r\n"));
    const std::string text = client.hear_all();
    EXPECT_TRUE(is_problem(text, 413)) << text;
    EXPECT_TRUE(has(text, "Connection: close\r\n"));
}

TEST(Listener, ChunkedBodyIsTakenWithinTheLimitAndRefusedOverIt) {
    const Served served;
    Client client(served.port());
    const std::string chunked = head("POST /x", "Transfer-Encoding: chunked\r\n");
    client.say(chunked + "3\r\nabc\r\n2;extension=1\r\nde\r\n0\r\nTrailer: 1\r\n\r\n");
    EXPECT_TRUE(client.hear().ends_with("<abcde>"));
    const std::string half(kBodyLimit / 2 + 1, 'x');
    client.say(chunked + "1f5\r\n" + half + "\r\n1f5\r\n" + half + "\r\n0\r\n\r\n");  // 0x1f5 = 501
    EXPECT_TRUE(is_problem(client.hear(), 413));
    client.say(post("/x", "small"));
    EXPECT_TRUE(client.hear().ends_with("<small>"));
}

TEST(Listener, EndlessChunkedBodyIsCutOff) {
    const Served served;
    Client client(served.port());
    client.say(head("POST /x", "Transfer-Encoding: chunked\r\n") + "fffffffff\r\n" + std::string(5 * kBodyLimit, 'x'));
    EXPECT_TRUE(is_problem(client.hear_all(), 413));
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
        {"range that is none", head("GET /x", "Range: bytes=0-0,what\r\n"), 416},
        {"long target", head("GET /" + std::string(9'000, 'x')), 414},
        {"target without end", "GET /" + std::string(9'000, 'x'), 414},
        {"long header", head("GET /x", "X: " + std::string(9'000, 'x') + "\r\n"), 431},
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
    large.say(head("POST /x", "Expect: 100-continue\r\nContent-Length: 2000\r\n"));
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
}

TEST(Listener, StopLetsARunningRequestEnd) {
    std::latch begun(1), release(1);
    Served served([&](const Request& request) {
        begun.count_down();
        release.wait();
        return echo(request);
    });
    Client client(served.port());
    client.say(head("GET /slow"));
    begun.wait();
    served.listener().stop();
    release.count_down();
    const std::string text = client.hear_all();
    EXPECT_TRUE(has(text, "GET /slow\n")) << text;
    EXPECT_TRUE(has(text, "Connection: close\r\n")) << text;
}

TEST(Listener, StopBeforeServingIsNotForgotten) {
    Listener listener(Served::options(), echo, problem);
    ASSERT_TRUE(std::holds_alternative<int>(listener.bind()));
    listener.stop();
    EXPECT_TRUE(listener.serve());
}

}  // namespace
}  // namespace tuftwave::server
