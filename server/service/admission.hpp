#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

#include "api/exchange.hpp"

namespace tuftwave::server {

/// Takes the answer to one request: to be called once, by any thread.
using Reply = std::function<void(Response)>;

/// A request whose body is worth reading.
struct Admission {
    std::size_t most_body_bytes = 0;
    /// Answers the complete request, now or later. It is asked to stop when the client has gone; whoever answers may do
    /// so, too.
    std::function<void(Request, std::stop_source, Reply)> answer;
};

}  // namespace tuftwave::server
