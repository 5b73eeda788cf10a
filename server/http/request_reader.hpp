#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "api/exchange.hpp"
#include "http/chunk_reader.hpp"
#include "http/request_head.hpp"

namespace tuftwave::server {

/// Takes requests out of a connection's bytes, one after the other and however the bytes are split. Knows neither a
/// socket nor a clock.
class RequestReader {
  public:
    enum class Step {
        kWantsMore,
        kHead,     ///< head() is complete: say allow_body() or skip_body() before the next take()
        kRequest,  ///< take_request() has it
        kRefused,  ///< refusal() says why; nothing more can be read from this connection
    };

    /// Goes on until something is to be done. @param bytes  shortened by what was taken
    Step take(std::string_view& bytes);

    const RequestHead& head() const { return head_; }

    /// Reads the body on. @param most  bytes that it may have, else it is refused with 413
    void allow_body(std::size_t most);

    /// The request is over with its head, since it has no body, or whoever reads takes that himself. The reader is then
    /// at the next one.
    void skip_body() { *this = {}; }

    /// The complete request. The reader is then at the next one.
    Request take_request();

    int refusal() const { return refusal_; }
    bool has_begun() const { return !text_.empty() || is_in_body_; }
    bool is_in_body() const { return is_in_body_; }
    std::size_t body_bytes() const { return head_.request.body.size(); }

    /// The bytes of a body that are still to come, if they are known; else as many as there may be.
    std::size_t body_bytes_left() const;

  private:
    bool take_head(std::string_view& bytes);
    Step take_body(std::string_view& bytes);
    bool refuse(int status);

    std::string text_;  // of the head
    std::size_t line_begin_ = 0;
    std::size_t lines_ = 0;
    RequestHead head_;
    ChunkReader chunks_;
    std::size_t most_body_bytes_ = 0;
    bool is_in_body_ = false;
    int refusal_ = 0;
};

}  // namespace tuftwave::server
