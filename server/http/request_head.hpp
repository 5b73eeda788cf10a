#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "api/exchange.hpp"

namespace tuftwave::server {

/// The most that the head of a request may be.
inline constexpr std::size_t kMostTargetBytes = 2'048;
inline constexpr std::size_t kMostFirstLineBytes = 4'096;
inline constexpr std::size_t kMostHeadBytes = 16 * 1024;  ///< with the first line and the blank one
inline constexpr std::size_t kMostHeaders = 64;

/// What a request's head says, and how its body is delimited. Two readers that disagree on where a body ends let one
/// client's bytes become another one's request, so everything doubtful is refused (RFC 9112).
struct RequestHead {
    int fault = 0;    ///< the status that refuses it; 0 if it is sound, and then all the rest holds
    Request request;  ///< without its body
    bool is_http_1_0 = false;
    bool wants_close = false;       ///< "Connection: close", or HTTP/1.0
    bool expects_continue = false;  ///< the body waits for "100 Continue"
    bool is_chunked = false;
    std::uint64_t length = 0;  ///< bytes of the body, if not chunked

    bool has_body() const { return is_chunked || length > 0; }
};

/// The status that refuses a request's first line, or 0. @param line  without its CR LF
int fault_of_first_line(std::string_view line);

/// Reads a head. @param text  from the first line to the blank one, every line with its CR LF, none of it elsewhere
RequestHead parse_head(std::string_view text);

}  // namespace tuftwave::server
