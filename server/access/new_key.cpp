#include "access/new_key.hpp"

#include <sys/random.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <system_error>

#include "access/digest.hpp"

namespace tuftwave::server {
namespace {

using Bytes = std::array<unsigned char, 32>;

Bytes random_bytes() {
    Bytes bytes{};
    for (std::size_t have = 0; have < bytes.size();) {
        const ssize_t got = ::getrandom(bytes.data() + have, bytes.size() - have, 0);
        if (got < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), "no random bytes");
        if (got > 0) have += static_cast<std::size_t>(got);
    }
    return bytes;
}

/// RFC 4648, section 5, without padding.
std::string base64url(const Bytes& bytes) {
    static constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    std::string text;
    std::uint32_t bits = 0;
    int count = 0;
    for (const unsigned char byte : bytes) {
        bits = bits << 8 | byte;
        for (count += 8; count >= 6; count -= 6) text += kLetters[bits >> (count - 6) & 63];
    }
    if (count > 0) text += kLetters[bits << (6 - count) & 63];
    return text;
}

std::string hex(const Digest& digest) {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (const unsigned char byte : digest) {
        text += kDigits[byte >> 4];
        text += kDigits[byte & 15];
    }
    return text;
}

}  // namespace

NewKey new_key(const std::string& name) {
    const std::string key = "tw_" + base64url(random_bytes());
    return {key, name + " " + hex(sha256(key))};
}

}  // namespace tuftwave::server
