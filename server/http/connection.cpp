#include "http/connection.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace tuftwave::server {
namespace {

constexpr std::size_t kBufferBytes = 16 * 1024;
constexpr auto kTick = std::chrono::milliseconds(50);            // how soon stopping is noticed
constexpr auto kLastRequest = std::chrono::milliseconds(5'000);  // for what is being sent while stopping
constexpr auto kLinger = std::chrono::milliseconds(1'000);
constexpr std::size_t kLingerBytes = 4 * 1024 * 1024;

}  // namespace

Connection::Connection(const int descriptor, const ConnectionLimits& limits, const std::atomic<bool>& stopping)
    : descriptor_(descriptor), limits_(limits), stopping_(stopping), buffer_(kBufferBytes) {}

Connection::~Connection() {
    if (is_closing_ && has_answered_) linger();
    ::shutdown(descriptor_, SHUT_RDWR);
    ::close(descriptor_);
}

/// Closing while the client still sends would reset the connection, and the answer would be lost on its way.
void Connection::linger() {
    ::shutdown(descriptor_, SHUT_WR);
    const auto until = Clock::now() + kLinger;
    std::size_t total = 0;
    while (total < kLingerBytes && !stopping_ && wait_until(POLLIN, until, true)) {
        const ssize_t got = ::recv(descriptor_, buffer_.data(), buffer_.size(), MSG_DONTWAIT);
        if (got <= 0) return;
        total += static_cast<std::size_t>(got);
    }
}

/// @param gives_way  whether it returns early, with false, when the server stops and nothing is there
bool Connection::wait_until(const short event, const Clock::time_point deadline, const bool gives_way) {
    for (;;) {
        const bool stopping = stopping_;
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
        const auto wait = std::clamp(left, std::chrono::milliseconds(0),
                                     stopping && gives_way ? std::chrono::milliseconds(0) : kTick);
        pollfd ready{descriptor_, event, 0};
        const int count = ::poll(&ready, 1, static_cast<int>(wait.count()));
        if (count > 0) return true;
        if (count < 0 && errno != EINTR) return false;
        if (left.count() <= 0 || (stopping && gives_way)) return false;
    }
}

bool Connection::fill() {
    if (stopping_) deadline_ = std::min(deadline_, Clock::now() + kLastRequest);
    for (;;) {
        if (!wait_until(POLLIN, std::min(deadline_, Clock::now() + stall_), false)) {
            refuse(408);
            return false;
        }
        const ssize_t got = ::recv(descriptor_, buffer_.data(), buffer_.size(), MSG_DONTWAIT);
        if (got < 0 && (errno == EAGAIN || errno == EINTR)) continue;
        begin_ = 0;
        end_ = got > 0 ? static_cast<std::size_t>(got) : 0;
        return got > 0;
    }
}

int Connection::refuse(const int status) {
    if (fault_ == 0) fault_ = status;
    is_closing_ = true;
    return -1;
}

bool Connection::wait_for_request() {
    head_bytes_ = line_bytes_ = head_lines_ = 0;
    previous_ = 0;
    pending_ = {};
    fault_ = 0;
    has_answered_ = false;
    if (begin_ == end_) {
        if (!wait_until(POLLIN, Clock::now() + limits_.idle, true)) return false;
        deadline_ = Clock::now() + limits_.head;
        stall_ = limits_.head;
        return fill();
    }
    deadline_ = Clock::now() + limits_.head;
    stall_ = limits_.head;
    return true;
}

int Connection::head_byte() {
    if (!pending_.empty()) {
        const char next = pending_.front();
        pending_.remove_prefix(1);
        return next;
    }
    if (fault_ != 0 || (begin_ == end_ && !fill())) return -1;
    const char byte = buffer_[begin_++];
    const bool is_first_line = head_lines_ == 0;
    if (++head_bytes_ > limits_.head_bytes || ++line_bytes_ > limits_.line_bytes)
        return refuse(is_first_line ? 414 : 431);
    if (byte == '\0' || (byte == '\n') != (previous_ == '\r')) return refuse(400);
    if (byte == '\n') {
        const bool is_blank = line_bytes_ == 2;
        if (++head_lines_ > limits_.head_lines && !is_blank) return refuse(431);
        line_bytes_ = 0;
    }
    if (byte == '%' && !is_first_line) pending_ = "25";
    previous_ = byte;
    return static_cast<unsigned char>(byte);
}

void Connection::head_ended() {
    deadline_ = Clock::now() + limits_.body;
    stall_ = limits_.stall;
}

std::ptrdiff_t Connection::read(char* const to, const std::size_t count) {
    if (begin_ == end_ && !fill()) return fault_ != 0 ? -1 : 0;
    const std::size_t part = std::min(count, end_ - begin_);
    std::copy_n(buffer_.data() + begin_, part, to);
    begin_ += part;
    return static_cast<std::ptrdiff_t>(part);
}

bool Connection::write(const std::string_view bytes) {
    auto deadline = Clock::now() + limits_.write + std::chrono::seconds(bytes.size() / limits_.write_rate);
    for (std::string_view rest = bytes; !rest.empty();) {
        const ssize_t sent = ::send(descriptor_, rest.data(), rest.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
        if (sent > 0) {
            has_answered_ = true;
            rest.remove_prefix(static_cast<std::size_t>(sent));
            continue;
        }
        if (stopping_) deadline = std::min(deadline, Clock::now() + kLastRequest);
        const bool is_full = sent < 0 && (errno == EAGAIN || errno == EINTR);
        if (!is_full || !wait_until(POLLOUT, std::min(deadline, Clock::now() + limits_.stall), false)) {
            is_closing_ = true;
            return false;
        }
    }
    return true;
}

}  // namespace tuftwave::server
