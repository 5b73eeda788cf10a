#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "access/digest.hpp"
#include "api/exchange.hpp"

namespace tuftwave::server {

/// Somebody who may call. The key itself is nowhere, only its hash.
struct Key {
    std::string name;            ///< 1 to 64 of A-Z a-z 0-9 . _ -
    Digest hash{};               ///< SHA-256 of the key as it is sent
    std::optional<double> rate;  ///< units a second, 0 for any number; nothing if the file has none
};

/// Why a key file cannot be used, with the line's number and never what stands there.
struct KeyFileError {
    std::string message;
};

/// Keys that are valid side by side, so that one can take another's place without a gap. Immutable, so thread-safe.
class Keys {
  public:
    Keys() = default;  ///< nobody

    /// Reads lines NAME SHA256-HEX [RATE]; empty lines and those that start with # count for nothing.
    /// @errors  a line that is none of these, a name or hash that stands twice, no key at all, more than 1,000
    static std::variant<Keys, KeyFileError> parse(std::string_view text);

    /// The place of the key whose hash this key has. Compares with every hash to the end, whatever it finds.
    std::optional<std::size_t> find(std::string_view key) const;

    std::size_t size() const { return keys_.size(); }
    const Key& at(std::size_t place) const { return keys_.at(place); }

  private:
    std::vector<Key> keys_;
};

struct KeyFile {
    Keys keys;
    std::string warning;  ///< one sentence without the path; "" if there is none
};

/// Reads a file of at most 1 MiB. It warns where others may read it or change it.
std::variant<KeyFile, KeyFileError> read_key_file(const std::string& path);

bool is_key_name(std::string_view name);

/// What a request has to show.
struct Credentials {
    bool is_given = false;  ///< whether it tried with a key, be it well-formed or not
    std::string_view key;   ///< 20 to 200 characters of visible ASCII; "" if there is none
};

/// The key of exactly one `Authorization: Bearer KEY`. @param headers  names in lower case; must outlive the answer
Credentials credentials_of(const NameValues& headers);

}  // namespace tuftwave::server
