#include "access/keys.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <utility>

namespace tuftwave::server {
namespace {

constexpr std::size_t kMostKeys = 1'000;  // each request is compared with all of them
constexpr std::size_t kMostFileBytes = 1024 * 1024;
constexpr std::size_t kLongestName = 64;
constexpr std::size_t kShortestKey = 20, kLongestKey = 200;
constexpr double kMostRate = 1e6;
constexpr std::string_view kScheme = "bearer";
constexpr std::string_view kBlank = " \t";

KeyFileError at_line(const std::size_t number, const std::string& what) {
    return {"line " + std::to_string(number) + " of the key file: " + what};
}

/// What stands before the separator, or everything; `text` keeps what stands behind it.
std::string_view cut(std::string_view& text, const std::string_view separators) {
    const std::size_t end = text.find_first_of(separators);
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return part;
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    while (!line.empty()) {
        const std::string_view word = cut(line, kBlank);
        if (!word.empty()) words.push_back(word);
    }
    return words;
}

std::optional<Digest> digest_of(const std::string_view hex) {
    Digest digest{};
    if (hex.size() != 2 * digest.size()) return {};
    for (std::size_t i = 0; i < digest.size(); ++i) {
        const char* const begin = hex.data() + 2 * i;
        const auto [end, error] = std::from_chars(begin, begin + 2, digest[i], 16);
        if (error != std::errc{} || end != begin + 2) return {};
    }
    return digest;
}

std::optional<double> rate_of(const std::string_view text) {
    double rate = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rate);
    if (error != std::errc{} || end != text.data() + text.size()) return {};
    if (!(rate >= 0 && rate <= kMostRate)) return {};
    return rate;
}

std::variant<Key, KeyFileError> key_of(const std::vector<std::string_view>& words, const std::size_t number) {
    if (words.size() < 2 || words.size() > 3) return at_line(number, "expected NAME SHA256 [RATE]");
    if (!is_key_name(words[0])) return at_line(number, "a name has 1 to 64 of A-Z a-z 0-9 . _ -");
    const std::optional<Digest> hash = digest_of(words[1]);
    if (!hash) return at_line(number, "the hash is not 64 hexadecimal digits");
    Key key{std::string(words[0]), *hash, {}};
    if (words.size() == 3) {
        key.rate = rate_of(words[2]);
        if (!key.rate) return at_line(number, "the rate is not a number from 0 to 1000000");
    }
    return key;
}

/// A descriptor that is closed at the end.
struct Descriptor {
    const int number;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
};

/// The whole file; nothing if it cannot be read or is too long.
std::optional<std::string> content_of(const int descriptor) {
    std::string text;
    std::array<char, 4096> buffer;
    for (;;) {
        const ssize_t got = ::read(descriptor, buffer.data(), buffer.size());
        if (got == 0) return text;
        if (got < 0 && errno == EINTR) continue;
        if (got < 0 || text.size() > kMostFileBytes) return {};
        text.append(buffer.data(), static_cast<std::size_t>(got));
    }
}

bool equal_ignoring_case(const std::string_view text, const std::string_view lower) {
    return std::equal(text.begin(), text.end(), lower.begin(), lower.end(), [](const char a, const char b) {
        return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + ('a' - 'A')) : a) == b;
    });
}

bool is_key(const std::string_view text) {
    return text.size() >= kShortestKey && text.size() <= kLongestKey &&
           std::all_of(text.begin(), text.end(), [](const char c) { return c > ' ' && c < '\x7f'; });
}

}  // namespace

std::variant<Keys, KeyFileError> Keys::parse(std::string_view text) {
    Keys keys;
    for (std::size_t number = 1; !text.empty(); ++number) {
        std::string_view line = cut(text, "\n");
        if (line.ends_with('\r')) line.remove_suffix(1);
        const std::vector<std::string_view> words = words_of(line);
        if (words.empty() || words[0].starts_with('#')) continue;
        auto read = key_of(words, number);
        if (const auto* error = std::get_if<KeyFileError>(&read)) return *error;
        Key& key = std::get<Key>(read);
        for (const Key& other : keys.keys_) {
            if (other.name == key.name) return at_line(number, "the name stands in an earlier line");
            if (other.hash == key.hash) return at_line(number, "the hash stands in an earlier line");
        }
        if (keys.size() == kMostKeys) return at_line(number, "there are more than 1000 keys");
        keys.keys_.push_back(std::move(key));
    }
    if (keys.size() == 0) return KeyFileError{"the key file has no key; tuftwave-server new-key NAME makes one"};
    return keys;
}

std::optional<std::size_t> Keys::find(const std::string_view key) const {
    const Digest hash = sha256(key);
    std::size_t found = 0;  // the place and one more, put together without a branch
    for (std::size_t place = 0; place < keys_.size(); ++place)
        found += static_cast<std::size_t>(equal_in_constant_time(keys_[place].hash, hash)) * (place + 1);
    if (found == 0) return {};
    return found - 1;
}

std::variant<KeyFile, KeyFileError> read_key_file(const std::string& path) {
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    struct stat state {};
    const std::optional<std::string> text =
        file.number >= 0 && ::fstat(file.number, &state) == 0 ? content_of(file.number) : std::nullopt;
    if (!text) return KeyFileError{"the key file cannot be read, or is longer than 1 MiB"};
    auto keys = Keys::parse(*text);
    if (const auto* error = std::get_if<KeyFileError>(&keys)) return *error;
    KeyFile made{std::get<Keys>(std::move(keys)), ""};
    if ((state.st_mode & (S_IROTH | S_IWOTH | S_IWGRP)) != 0)
        made.warning = "others may read or change the key file; chmod 600 it";
    return made;
}

bool is_key_name(const std::string_view name) {
    return !name.empty() && name.size() <= kLongestName && std::all_of(name.begin(), name.end(), [](const char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' || c == '_' ||
               c == '-';
    });
}

Credentials credentials_of(const NameValues& headers) {
    Credentials found;
    for (const auto& [name, value] : headers) {
        if (name != "authorization") continue;
        if (found.is_given) return {true, {}};  // which of two should count?
        std::string_view rest = value;
        const bool is_bearer = equal_ignoring_case(cut(rest, kBlank), kScheme);
        rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
        found.is_given = true;
        if (is_bearer && is_key(rest)) found.key = rest;
    }
    return found;
}

}  // namespace tuftwave::server
