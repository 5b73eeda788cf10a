#pragma once

#include <stop_token>
#include <variant>

#include "api/exchange.hpp"
#include "api/problem.hpp"
#include "tuftwave/for_each.hpp"
#include "tuftwave/limits.hpp"

namespace tuftwave::server {

/// What an operation may use besides its request.
struct Context {
    const Limits& limits;
    const ForEach& for_each;
    std::stop_token stop;  ///< once set, the answer may be incomplete: whoever set it throws it away
};

using Answer = std::variant<Response, Problem>;

/// An operation: a pure function of its request, the same on every replica.
using Operation = Answer (*)(const Request& request, const Context& context);

}  // namespace tuftwave::server
