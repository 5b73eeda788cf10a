#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>

#include "http/answerer.hpp"
#include "http/library.hpp"
#include "http/poller.hpp"
#include "http/request_reader.hpp"
#include "http/sockets.hpp"

namespace tuftwave::server {

/// How long each part of an exchange may take. All are totals, so that a client that sends or takes one byte now and
/// then gains nothing.
struct Patience {
    std::chrono::milliseconds idle{15'000};   ///< until a request begins
    std::chrono::milliseconds head{5'000};    ///< from a request's first byte to the end of its headers
    std::chrono::milliseconds body{10'000};   ///< from there to the end of its body
    std::chrono::milliseconds write{15'000};  ///< for an answer, and a second more for every `write_rate` bytes
    std::chrono::milliseconds stall{10'000};  ///< without a byte of an answer taken
    std::chrono::milliseconds linger{2'000};  ///< behind a last answer
    std::size_t write_rate = 64 * 1024;       ///< bytes per second
};

/// One client: its socket, what it sent and what it gets. Moves bytes and keeps the time; what they mean is decided by
/// the listener.
class Connection {
  public:
    using Clock = std::chrono::steady_clock;
    enum class Phase { kReading, kAnswering, kWriting, kLingering };
    enum class Sent { kAll, kSome, kFailed };

    Connection(Descriptor socket, const std::uint64_t its_id) : id(its_id), socket_(std::move(socket)) {}
    ~Connection() { forget_message(); }

    const std::uint64_t id;
    RequestReader reader;
    Admission admission;         ///< of the request that is being read
    std::stop_source work;       ///< what computes the answer, in kAnswering
    Interest interest;           ///< that the poller was told
    std::size_t requests = 0;    ///< handed over
    std::size_t body_bytes = 0;  ///< counted against the listener's budget
    bool is_gone = false;        ///< closed, but an answer is still being made

    Phase phase() const { return phase_; }

    /// Reads once, into the buffer. @return  nothing if nothing has come; ended() then tells of the end
    std::string_view receive(std::span<char> buffer);
    bool has_ended() const { return has_ended_; }

    /// Keeps what was received and is another request's.
    void keep(std::string_view bytes) { kept_ = bytes; }
    std::string take_kept() { return std::exchange(kept_, {}); }

    /// A request is complete: somebody makes its answer.
    void begin_answering() { phase_ = Phase::kAnswering; }

    /// @param closes  whether the connection is over behind this answer
    void begin_writing(Message message, bool closes);
    /// Memory of the answer that is being written: all of it stays until its last byte is sent.
    std::size_t held() const { return message_.memory(); }
    std::size_t unsent() const { return message_.size() - sent_; }
    bool closes() const { return closes_; }
    /// Writes what the socket takes, about so many bytes at most. On kAll it reads again.
    Sent send(std::size_t most);
    /// Writes a few bytes besides. @return  false if they do not fit
    bool send_at_once(std::string_view bytes);

    /// Says that nothing more will come, and waits until the client says so, too: closing while it still sends would
    /// reset the connection, and the answer could be lost on its way.
    void begin_lingering();
    /// Drops what still comes. @return  false at the end
    bool drop_input();

    void close() { socket_.close(); }
    int socket() const { return socket_.number(); }

    /// When the present phase is too long. @param idle  patience with a connection that has nothing to do
    Clock::time_point due(const Patience& patience, std::chrono::milliseconds idle) const;
    bool is_idle() const { return phase_ == Phase::kReading && !reader.has_begun(); }

    /// Notes that a part has begun: the head, the body, or waiting.
    void restart_clock() { since_ = Clock::now(); }

  private:
    void forget_message();

    Descriptor socket_;
    Phase phase_ = Phase::kReading;
    Clock::time_point since_ = Clock::now();     // of the present part
    Clock::time_point progress_ = Clock::now();  // of writing
    std::string kept_;
    Message message_;
    std::size_t sent_ = 0;
    std::size_t dropped_ = 0;
    bool closes_ = false;
    bool has_ended_ = false;
};

}  // namespace tuftwave::server
