#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "api/exchange.hpp"

namespace tuftwave::server {

/// An answer as it goes over the wire. The body is apart, so that a large one is never copied.
struct Message {
    std::string head, body;
    std::string_view constant{};  ///< in place of `body`, as in Response
    std::size_t first = 0;        ///< where in `body` what is sent begins

    std::string_view content() const { return constant.empty() ? std::string_view(body).substr(first) : constant; }
    std::size_t size() const { return head.size() + content().size(); }
    std::size_t memory() const { return head.size() + body.size(); }
};

/// The HTTP library. It is shown a request of ours over a stream in memory, once for each status, and words the status
/// line; to word every head it would take longer than all else that a small answer needs. Nothing that a client sent
/// reaches it, so its parsers have nothing to trip over, and its limits, routes, ranges, codings and multipart forms
/// never come into play.
class Library {
  public:
    Library();
    ~Library();
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;

    /// @param method  GET, HEAD, POST or OPTIONS
    /// @param closes  whether the connection is closed behind this answer
    /// @return  status line, headers, and the body unless it was HEAD; a header that is not one line is left out.
    ///          Called by several threads at once.
    Message message(std::string_view method, Response answer, bool closes) const;

  private:
    class Server;
    std::unique_ptr<Server> server_;
};

}  // namespace tuftwave::server
