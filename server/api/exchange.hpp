#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tuftwave::server {

using NameValues = std::vector<std::pair<std::string, std::string>>;

/// A request as the service sees it: complete, and without a socket.
struct Request {
    std::string method;  ///< "GET", "POST", ... as sent
    std::string path;    ///< decoded, without the query
    NameValues query;    ///< decoded, in the order sent
    NameValues headers;  ///< names in lower case
    std::string body;

    /// The first header of that name, "" if there is none. @param name  in lower case
    const std::string& header(const std::string& name) const;
};

/// What goes back.
struct Response {
    int status = 200;
    std::string content_type;
    std::string body;
    NameValues headers;           ///< besides Content-Type and Content-Length
    std::string_view constant{};  ///< in place of `body`: bytes that live as long as the program, sent without a copy
    std::size_t first = 0;        ///< where in `body` what is sent begins: a file that was written in place

    /// What is sent, whoever holds it.
    std::string_view content() const { return constant.empty() ? std::string_view(body).substr(first) : constant; }
};

}  // namespace tuftwave::server
