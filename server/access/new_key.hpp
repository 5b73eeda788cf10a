#pragma once

#include <string>

namespace tuftwave::server {

struct NewKey {
    std::string key;   ///< what its owner sends: "tw_" and 32 random bytes in base64url
    std::string line;  ///< what the key file gets, without its end
};

/// A fresh random key. @param name  one that is_key_name() accepts
/// Throws std::system_error if the system has no random bytes.
NewKey new_key(const std::string& name);

}  // namespace tuftwave::server
