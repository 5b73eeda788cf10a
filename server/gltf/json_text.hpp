#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace tuftwave::server::gltf {

/// Writes JSON text piece by piece, without a tree of it: a hairstyle's has a million values. Either into memory that
/// is large enough, or nowhere, to learn how much that is. Whoever calls it sees to the order of keys.
class JsonText {
  public:
    /// @param out  where the text goes; null only counts
    explicit JsonText(char* out = nullptr) : out_(out) {}

    std::size_t bytes() const { return bytes_; }

    // Inlined, since what is written is mostly of known length, and a copy of that is no call.
    [[gnu::always_inline]] JsonText& raw(std::string_view text) {
        if (out_ != nullptr) std::memcpy(out_ + bytes_, text.data(), text.size());
        bytes_ += text.size();
        return *this;
    }
    JsonText& text(std::string_view value);  ///< in quotes, escaped
    JsonText& number(double value) {         ///< the shortest digits that say it, with a point or an exponent
        // Most numbers of a skeleton are these.
        if (value == 1) return raw("1.0");
        if (value == 0 && !std::signbit(value)) return raw("0.0");
        return searched(value);
    }
    JsonText& number(std::size_t value);
    JsonText& number(int value);

    /// A member's key and, unless it is an object's first, the comma before it. @param key  needs no escapes
    [[gnu::always_inline]] JsonText& key(std::string_view key) {
        // At once, since after each byte that is written a compiler must look again where the next one goes.
        const std::size_t comma = is_first_ ? 0 : 1;
        if (out_ != nullptr) {
            char* at = out_ + bytes_;
            *at = ',';
            at += comma;
            *at++ = '"';
            std::memcpy(at, key.data(), key.size());
            at += key.size();
            *at++ = '"';
            *at = ':';
        }
        bytes_ += comma + key.size() + 3;
        is_first_ = false;
        return *this;
    }
    JsonText& open(char bracket) {  ///< { or [
        is_first_ = true;
        return put(bracket);
    }
    JsonText& close(char bracket) {  ///< } or ]
        is_first_ = false;
        return put(bracket);
    }
    void skip(std::size_t bytes) { bytes_ += bytes; }  ///< what somebody else writes
    JsonText& next() {                                 ///< the comma before an item that is not the first
        if (!is_first_) put(',');
        is_first_ = false;
        return *this;
    }

  private:
    static constexpr std::size_t kMostDigits = 32;

    JsonText& searched(double value);  ///< whose digits must be searched for

    /// Writes a number where it belongs. @param write  as to_chars(), and touches no more than it writes
    template <class Write>
    JsonText& digits(const Write& write);

    JsonText& put(char c) {
        if (out_ != nullptr) out_[bytes_] = c;
        ++bytes_;
        return *this;
    }

    char* out_;
    std::size_t bytes_ = 0;
    bool is_first_ = true;
};

/// The text of a glTF object's extras: without members and items that are null, and with null for what is empty, since
/// that is what our files have always said.
std::string extras_text(const nlohmann::json& extras);

}  // namespace tuftwave::server::gltf
