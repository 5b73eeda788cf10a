#pragma once

#include "character/file_value.hpp"

namespace tuftwave::server::character {

/// Refuses a file that says it cannot be read without an extension, unless we know that the extension changes nothing
/// of what we read or add. The fault names the extension.
void check_required_extensions(const FileValue& required);

}  // namespace tuftwave::server::character
