#pragma once

#include "config/config.hpp"

namespace tuftwave::server {

/// Serves until SIGTERM or SIGINT: then /readyz says no, after the drain time the listeners close, running requests
/// end. A second signal ends the process at once. Prints one line with the addresses on standard output when it is
/// ready. Call it before any thread is started, since it blocks signals.
/// @return  the exit code: 0 after a signal, 1 if it cannot serve, 2 if the configuration does not let it
int run(const Config& config);

}  // namespace tuftwave::server
