#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "api/exchange.hpp"

namespace tuftwave::server {

/// A request's target, decoded.
struct Target {
    std::string path;
    NameValues query;  ///< in the order sent
};

/// @param target  as sent: "/v1/tufts?format=glb"
/// @return  nothing if it is not an absolute path, or is badly percent-encoded
std::optional<Target> parse_target(std::string_view target);

/// How a body is delimited, or the status that refuses the request. Two readers that disagree on where a body ends let
/// one client's bytes become another one's request, so everything doubtful is refused (RFC 9112, section 6.3).
struct Framing {
    int fault = 0;  ///< 0 if sound, else 400, 411 or 415
    bool is_chunked = false;
    std::uint64_t length = 0;  ///< bytes, if not chunked
};

/// @param request  method and headers count; names in lower case
Framing framing_of(const Request& request, bool is_http_1_0);

/// Reads up to `count` bytes; 0 at the end of the connection, negative if it failed or took too long.
using ByteSource = std::function<std::ptrdiff_t(char* to, std::size_t count)>;

/// A body, or the status that refuses it.
struct Body {
    int fault = 0;         ///< 0 if it is complete, else 400 or 413
    bool is_over = false;  ///< the source stands at the next request
    std::string bytes;
};

/// Reads a body and stores at most `limit` bytes. One that is longer is read on to its end without being stored, so
/// that the answer reaches the client and the connection stays of use; but only up to four times the limit.
Body read_body(const ByteSource& source, const Framing& framing, std::size_t limit);

}  // namespace tuftwave::server
