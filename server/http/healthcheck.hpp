#pragma once

#include <string>

namespace tuftwave::server {

/// Asks once, over a connection of its own, for at most three seconds or so.
/// @return  the status of the answer to GET, 0 if there is none
int http_status(const std::string& host, int port, const std::string& path);

}  // namespace tuftwave::server
