#include "http/connection.hpp"

#include <sys/socket.h>
#include <sys/uio.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include "memory/buffers.hpp"

namespace tuftwave::server {
namespace {

constexpr std::size_t kDroppedAtOnce = 1024 * 1024;  // then it is the next connection's turn
constexpr std::size_t kMostDropped = 128 * 1024 * 1024;

bool would_block(const ssize_t result) {
    return result < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
}

/// Empties it and lets its memory go, which a string that is assigned to keeps.
template <class Thing>
void release(Thing& thing) {
    [[maybe_unused]] const Thing old = std::exchange(thing, Thing());
}

}  // namespace

std::string_view Connection::receive(const std::span<char> buffer) {
    const ssize_t got = ::recv(socket_.number(), buffer.data(), buffer.size(), 0);
    has_ended_ = got == 0 || (got < 0 && !would_block(got));
    return got > 0 ? std::string_view(buffer.data(), static_cast<std::size_t>(got)) : std::string_view();
}

void Connection::begin_writing(Message message, const bool closes) {
    message_ = std::move(message);
    sent_ = 0;
    closes_ = closes;
    phase_ = Phase::kWriting;
    since_ = progress_ = Clock::now();
}

Connection::Sent Connection::send(const std::size_t most) {
    for (std::size_t turn = 0; unsent() > 0;) {
        if (turn >= most) return Sent::kSome;
        const std::string_view head = std::string_view(message_.head).substr(std::min(sent_, message_.head.size()));
        const std::size_t body_sent = sent_ - (message_.head.size() - head.size());
        const std::string_view body = message_.content().substr(body_sent, most - turn);
        std::array<iovec, 2> pieces{iovec{const_cast<char*>(head.data()), head.size()},
                                    iovec{const_cast<char*>(body.data()), body.size()}};
        msghdr all{};
        all.msg_iov = pieces.data();
        all.msg_iovlen = pieces.size();
        const ssize_t sent = ::sendmsg(socket_.number(), &all, MSG_NOSIGNAL);
        if (would_block(sent)) return Sent::kSome;
        if (sent <= 0) return Sent::kFailed;
        sent_ += static_cast<std::size_t>(sent);
        turn += static_cast<std::size_t>(sent);
        progress_ = Clock::now();
    }
    forget_message();
    phase_ = Phase::kReading;
    since_ = Clock::now();
    return Sent::kAll;
}

void Connection::forget_message() {
    memory::give_back(std::move(message_.body));
    release(message_);
    sent_ = 0;
}

bool Connection::send_at_once(const std::string_view bytes) {
    return ::send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
}

void Connection::begin_lingering() {
    ::shutdown(socket_.number(), SHUT_WR);
    phase_ = Phase::kLingering;
    since_ = Clock::now();
    release(kept_);
    release(reader);
}

bool Connection::drop_input() {
    // TCP drops by itself what is read with MSG_TRUNC: nothing is copied.
    for (std::size_t turn = 0; turn < kDroppedAtOnce;) {
        const ssize_t got = ::recv(socket_.number(), nullptr, kDroppedAtOnce, MSG_TRUNC);
        if (would_block(got)) return true;
        if (got <= 0) return false;
        turn += static_cast<std::size_t>(got);
        dropped_ += static_cast<std::size_t>(got);
    }
    return dropped_ < kMostDropped;
}

Connection::Clock::time_point Connection::due(const Patience& patience, const std::chrono::milliseconds idle) const {
    switch (phase_) {
        case Phase::kReading:
            return since_ + (reader.is_in_body() ? patience.body : reader.has_begun() ? patience.head : idle);
        case Phase::kWriting: {
            const auto more = std::chrono::seconds(message_.size() / patience.write_rate);
            return std::min(since_ + patience.write + more, progress_ + patience.stall);
        }
        case Phase::kLingering:
            return since_ + patience.linger;
        case Phase::kAnswering:
            break;
    }
    return Clock::time_point::max();
}

}  // namespace tuftwave::server
