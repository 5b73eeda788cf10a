#pragma once

#include <string>
#include <variant>
#include <vector>

#include "api/exchange.hpp"

namespace tuftwave::server {

/// The pages elsewhere that may call from a browser (CORS): exact origins, no wildcard. Where none is listed no answer
/// says a word about it. Immutable, so thread-safe.
class Origins {
  public:
    Origins() = default;  ///< none

    /// @param list  "https://studio.example, http://localhost:5173", as browsers send them; "" for none
    /// @return  else one sentence for whoever starts the server
    static std::variant<Origins, std::string> parse(const std::string& list);

    bool is_on() const { return !origins_.empty(); }

    /// Whether a browser asks by this request what it may send.
    bool is_preflight(const Request& request) const;

    /// The answer to a preflight: 204, with what is allowed if its origin is listed.
    /// @param allow  the path's methods, "GET, HEAD, OPTIONS"
    Response preflight(const Request& request, const std::string& allow) const;

    /// Adds what an ordinary answer needs, errors included, so that a listed page may read it. That to a preflight
    /// has everything already.
    void add_headers(const Request& request, Response& response) const;

  private:
    /// The request's origin if it is listed, else "".
    std::string listed_origin(const Request& request) const;

    std::vector<std::string> origins_;
};

}  // namespace tuftwave::server
