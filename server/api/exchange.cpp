#include "api/exchange.hpp"

namespace tuftwave::server {

const std::string& Request::header(const std::string& name) const {
    static const std::string none;
    for (const auto& [key, value] : headers) {
        if (key == name) return value;
    }
    return none;
}

}  // namespace tuftwave::server
