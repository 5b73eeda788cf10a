#pragma once

#include <functional>
#include <variant>

#include "api/exchange.hpp"
#include "service/admission.hpp"

namespace tuftwave::server {

/// Who answers what a listener hears. Both are called by a thread that serves many, and nobody else until they
/// return.
struct Answerer {
    /// The head of a request has come, its body is not there. @param is_whole  all of it has come, too, so that an
    /// answer now lets the connection live. @return  an answer if the body is not wanted
    std::function<std::variant<Admission, Response>(const Request& head, bool is_whole)> admit;
    /// The answer to what is no request, or cannot be served: 400, 408, 411, 413, 414, 415, 417, 431, 501, 503, 505.
    std::function<Response(int status)> refuse;
};

}  // namespace tuftwave::server
