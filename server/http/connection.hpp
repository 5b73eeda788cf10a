#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string_view>
#include <vector>

namespace tuftwave::server {

/// What one connection may cost. All times are totals, so that a client that sends one byte now and then gains nothing.
struct ConnectionLimits {
    std::chrono::milliseconds idle{2'000};    ///< until a request begins
    std::chrono::milliseconds head{5'000};    ///< from a request's first byte to the end of its headers
    std::chrono::milliseconds body{60'000};   ///< from there to the end of its body
    std::chrono::milliseconds stall{10'000};  ///< without a single byte of a body in or an answer out
    std::chrono::milliseconds write{15'000};  ///< for an answer, and a second more for every `write_rate` bytes
    std::size_t write_rate = 64 * 1024;       ///< bytes per second
    std::size_t line_bytes = 8 * 1024;        ///< request line, or one header
    std::size_t head_bytes = 16 * 1024;       ///< request line and headers
    std::size_t head_lines = 65;              ///< request line and headers
};

/// One accepted socket, read and written under limits. What is read ahead is kept, so requests may come back to back.
class Connection {
  public:
    /// @param descriptor  closed with the connection
    /// @param stopping    once true, only a request that has arrived is still read
    Connection(int descriptor, const ConnectionLimits& limits, const std::atomic<bool>& stopping);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /// Waits for the first byte of the next request. @return  false if none came
    bool wait_for_request();

    /// The next byte of a request's head, or -1 at its end and where it breaks a limit: fault() then says which. Lines
    /// must end with CR LF. "%" comes as "%25" in headers, for a library that decodes their values.
    int head_byte();

    /// The head has been read; from here on the limits of a body hold.
    void head_ended();

    /// Reads up to `count` bytes of a body; 0 at the end of the connection, -1 if it failed or took too long.
    std::ptrdiff_t read(char* to, std::size_t count);

    /// Writes everything. @return  false if the client went away or takes it too slowly
    bool write(std::string_view bytes);

    /// The status for a request that broke a limit of its head or came too slowly; 0 if it did not.
    int fault() const { return fault_; }

    /// Whether anything has been written since the request began.
    bool has_answered() const { return has_answered_; }

    void close_after_this() { is_closing_ = true; }
    bool is_closing() const { return is_closing_ || stopping_; }

    int descriptor() const { return descriptor_; }

  private:
    using Clock = std::chrono::steady_clock;

    bool fill();
    bool wait_until(short event, Clock::time_point deadline, bool gives_way);
    void linger();
    int refuse(int status);

    const int descriptor_;
    const ConnectionLimits limits_;
    const std::atomic<bool>& stopping_;
    std::vector<char> buffer_;
    std::size_t begin_ = 0, end_ = 0;  // of what was read ahead
    Clock::time_point deadline_;       // of what is being read
    std::chrono::milliseconds stall_{0};
    std::size_t head_bytes_ = 0, line_bytes_ = 0, head_lines_ = 0;  // read so far
    char previous_ = 0;
    std::string_view pending_;  // to be handed out before the next byte
    int fault_ = 0;
    bool has_answered_ = false;
    bool is_closing_ = false;
};

}  // namespace tuftwave::server
