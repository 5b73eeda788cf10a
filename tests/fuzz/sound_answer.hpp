#pragma once

#include <string>

#include "api/operation.hpp"

namespace tuftwave::server::fuzz {

/// What is wrong with an operation's answer, whatever it was asked; "" if nothing is. A problem must be a client's
/// fault, with its slug, status and pointers; a file or document must read back as what its media type says.
std::string fault_of(const Answer& answer);

}  // namespace tuftwave::server::fuzz
