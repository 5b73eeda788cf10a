// Sends one request over and over on a bounded number of connections and prints how the answers came, as JSON.
//
//   tuftwave_load PORT PATH BODY RATE SECONDS CONNECTIONS      BODY "-" is GET; RATE 0 asks as fast as answers come
//
// With a rate, requests are due at fixed times whether answers have come or not, and an answer's time counts from when
// its request was due, so that a server that stalls cannot hide it. Python would be slower than what it measures.
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr auto kLastAnswers = std::chrono::seconds(20);  // for what is still on its way when the time is over
constexpr std::size_t kReadBytes = 256 * 1024;
constexpr std::size_t kLongestHead = 16 * 1024;

struct Options {
    int port = 0;
    std::string request;
    double rate = 0;  ///< per second; 0 as fast as answers come
    double seconds = 0;
    int connections = 0;
};

struct Connection {
    enum class State { kClosed, kConnecting, kFree, kBusy };
    State state = State::kClosed;
    int descriptor = -1;
    Clock::time_point due;
    std::size_t sent = 0;     ///< bytes of the request
    std::string head;         ///< of the answer, and while it is not whole what came with it
    int status = 0;           ///< 0 while the head is not whole
    std::size_t missing = 0;  ///< bytes of the answer's body
    bool closes = false;
    bool is_used = false;  ///< it has brought an answer before, so that the server may close it at any time
};

/// Times of the answers of one status.
struct Answers {
    std::vector<double> milliseconds;
    std::uint64_t without_retry_after = 0;
};

std::string lower(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    return out;
}

class Generator {
  public:
    explicit Generator(const Options& options)
        : options_(options), connections_(static_cast<std::size_t>(options.connections)), buffer_(kReadBytes) {
        epoll_ = ::epoll_create1(EPOLL_CLOEXEC);
    }

    void run() {
        start_ = Clock::now();
        end_ = start_ + std::chrono::duration_cast<Clock::duration>(Seconds(options_.seconds));
        std::array<epoll_event, 256> events;
        for (;;) {
            const auto now = Clock::now();
            if (now >= end_ && (busy_ == 0 || now >= end_ + kLastAnswers)) break;
            if (now < end_) send_what_is_due(now);
            const auto wait = std::clamp<std::chrono::nanoseconds>(
                next_wake() - Clock::now(), std::chrono::nanoseconds(0), std::chrono::milliseconds(100));
            const timespec timeout{0, static_cast<long>(wait.count())};
            const int count = ::epoll_pwait2(epoll_, events.data(), static_cast<int>(events.size()), &timeout, nullptr);
            for (int i = 0; i < count; ++i) look_at(connections_[events[static_cast<std::size_t>(i)].data.u32]);
        }
        lost_ += busy_;
    }

    void print() {
        const double seconds = Seconds(std::min(Clock::now(), end_) - start_).count();
        const auto due = options_.rate > 0 ? static_cast<std::uint64_t>(options_.rate * options_.seconds) : asked_;
        std::printf(
            "{\"seconds\": %.3f, \"due\": %llu, \"asked\": %llu, \"lost\": %llu, \"asked_again\": %llu, "
            "\"reconnected\": %llu, \"answers\": {",
            seconds, static_cast<unsigned long long>(due), static_cast<unsigned long long>(asked_),
            static_cast<unsigned long long>(lost_), static_cast<unsigned long long>(asked_again_),
            static_cast<unsigned long long>(reconnected_));
        const char* comma = "";
        for (auto& [status, answers] : answers_) {
            std::vector<double>& times = answers.milliseconds;
            std::sort(times.begin(), times.end());
            const auto quantile = [&](double share) {
                return times[std::min(times.size() - 1,
                                      static_cast<std::size_t>(share * static_cast<double>(times.size())))];
            };
            std::printf(
                "%s\"%d\": {\"count\": %zu, \"p50\": %.3f, \"p90\": %.3f, \"p99\": %.3f, \"max\": %.3f, "
                "\"without_retry_after\": %llu}",
                comma, status, times.size(), quantile(0.5), quantile(0.9), quantile(0.99), times.back(),
                static_cast<unsigned long long>(answers.without_retry_after));
            comma = ", ";
        }
        std::printf("}}\n");
    }

  private:
    using State = Connection::State;

    Clock::time_point due_time(const std::uint64_t number) const {
        return start_ +
               std::chrono::duration_cast<Clock::duration>(Seconds(static_cast<double>(number) / options_.rate));
    }

    Clock::time_point next_wake() const {
        if (options_.rate <= 0 || busy_ == connections_.size()) return Clock::now() + std::chrono::milliseconds(100);
        return due_time(asked_);
    }

    void send_what_is_due(const Clock::time_point now) {
        if (busy_ == connections_.size()) return;
        for (Connection& connection : connections_) {
            if (options_.rate > 0 && due_time(asked_) > now) return;
            if (connection.state == State::kBusy || connection.state == State::kConnecting) continue;
            connection.due = options_.rate > 0 ? due_time(asked_) : now;
            ++asked_;
            ++busy_;
            ask(connection);
        }
    }

    void ask(Connection& connection) {
        connection.sent = connection.missing = 0;
        connection.status = 0;
        connection.head.clear();
        if (connection.state == State::kFree) {
            connection.state = State::kBusy;
            send_more(connection);
        } else {
            connect(connection);
        }
    }

    void connect(Connection& connection) {
        ++reconnected_;
        connection.descriptor = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
        const int yes = 1;
        ::setsockopt(connection.descriptor, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(options_.port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        connection.state = State::kConnecting;
        if (::connect(connection.descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 &&
            errno != EINPROGRESS)
            return lose(connection);
        epoll_event event{EPOLLIN | EPOLLOUT | EPOLLET, {}};
        event.data.u32 = static_cast<std::uint32_t>(&connection - connections_.data());
        ::epoll_ctl(epoll_, EPOLL_CTL_ADD, connection.descriptor, &event);
    }

    void look_at(Connection& connection) {
        if (connection.state == State::kClosed) return;
        if (connection.state == State::kConnecting) connection.state = State::kBusy;
        if (connection.state == State::kBusy) send_more(connection);
        if (connection.state != State::kClosed) read(connection);
    }

    void send_more(Connection& connection) {
        while (connection.sent < options_.request.size()) {
            const ssize_t count = ::send(connection.descriptor, options_.request.data() + connection.sent,
                                         options_.request.size() - connection.sent, MSG_NOSIGNAL);
            if (count < 0 && (errno == EAGAIN || errno == ENOTCONN)) return;
            if (count < 0) return;  // what it was answered before it was refused is still to be read
            connection.sent += static_cast<std::size_t>(count);
        }
    }

    void read(Connection& connection) {
        for (;;) {
            const ssize_t count = ::recv(connection.descriptor, buffer_.data(), buffer_.size(), 0);
            if (count < 0 && errno == EAGAIN) return;
            if (count <= 0) return lose(connection);
            if (!take(connection, {buffer_.data(), static_cast<std::size_t>(count)})) return;
            if (static_cast<std::size_t>(count) < buffer_.size()) return;  // there is no more
        }
    }

    /// @return  whether the connection is still there
    bool take(Connection& connection, std::string_view bytes) {
        if (connection.state != State::kBusy) return false;  // an answer that nobody asked for ends up as lost
        if (connection.status == 0) {
            connection.head += bytes;
            const std::size_t gap = connection.head.find("\r\n\r\n");
            if (gap == std::string::npos) return connection.head.size() < kLongestHead;
            const std::string head = lower(std::string_view(connection.head).substr(0, gap + 2));
            connection.status = std::atoi(head.c_str() + 9);
            connection.missing = number_of(head, "\r\ncontent-length: ");
            connection.closes = head.find("\r\nconnection: close\r\n") != std::string::npos;
            if (connection.status == 503 && head.find("\r\nretry-after: ") == std::string::npos)
                ++answers_[503].without_retry_after;
            const std::size_t came = connection.head.size() - gap - 4;
            connection.missing -= std::min(connection.missing, came);
        } else {
            connection.missing -= std::min(connection.missing, bytes.size());
        }
        if (connection.missing == 0) finish(connection);
        return connection.state != State::kClosed;
    }

    static std::size_t number_of(const std::string& head, const std::string_view name) {
        const std::size_t at = head.find(name);
        std::size_t number = 0;
        if (at != std::string::npos) std::from_chars(head.data() + at + name.size(), head.data() + head.size(), number);
        return number;
    }

    void finish(Connection& connection) {
        const std::chrono::duration<double, std::milli> took = Clock::now() - connection.due;
        answers_[connection.status].milliseconds.push_back(took.count());
        --busy_;
        connection.state = State::kFree;
        connection.is_used = true;
        if (connection.closes) close(connection);
    }

    /// A server may close an idle connection just when a request is on its way: that is asked again (RFC 9112 9.3.1).
    void lose(Connection& connection) {
        const bool is_asked_again = connection.state == State::kBusy && connection.is_used && connection.head.empty();
        if (connection.state != State::kFree && !is_asked_again) {
            ++lost_;
            --busy_;
        }
        close(connection);
        if (!is_asked_again) return;
        ++asked_again_;
        ask(connection);
    }

    void close(Connection& connection) {
        ::close(connection.descriptor);
        connection.state = State::kClosed;
        connection.is_used = false;
    }

    const Options& options_;
    std::vector<Connection> connections_;
    std::vector<char> buffer_;
    int epoll_ = -1;
    Clock::time_point start_, end_;
    std::size_t busy_ = 0;
    std::uint64_t asked_ = 0, lost_ = 0, asked_again_ = 0, reconnected_ = 0;
    std::map<int, Answers> answers_;
};

std::string request(const std::string& path, const std::string& body_file) {
    if (body_file == "-") return "GET " + path + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
    std::ifstream file(body_file, std::ios::binary);
    const std::string body{std::istreambuf_iterator<char>(file), {}};
    return "POST " + path + " HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: " +
           std::to_string(body.size()) + "\r\n\r\n" + body;
}

}  // namespace

int main(int count, char** words) {
    if (count != 7) {
        std::fprintf(stderr, "usage: tuftwave_load PORT PATH BODY RATE SECONDS CONNECTIONS\n");
        return 2;
    }
    const Options options{std::atoi(words[1]), request(words[2], words[3]), std::atof(words[4]), std::atof(words[5]),
                          std::max(1, std::atoi(words[6]))};
    Generator generator(options);
    generator.run();
    generator.print();
    return 0;
}
