#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace tuftwave::server::fuzz {

/// Makes values out of bytes; where they are used up, everything is 0 or empty.
class ByteSource {
  public:
    explicit ByteSource(std::string_view bytes) : bytes_(bytes) {}

    unsigned byte() {
        if (bytes_.empty()) return 0;
        const auto first = static_cast<unsigned char>(bytes_.front());
        bytes_.remove_prefix(1);
        return first;
    }

    /// @return  least .. most
    int integer(int least, int most) {
        const unsigned number = byte() | byte() << 8;
        return least + static_cast<int>(number % static_cast<unsigned>(most - least + 1));
    }

    /// @return  least .. most, both included
    double number(double least, double most) { return least + (most - least) * integer(0, 65'535) / 65'535; }

    /// Any bytes. @param most  of them
    std::string raw(int most) {
        const auto length = std::min(static_cast<std::size_t>(integer(0, most)), bytes_.size());
        const std::string text(bytes_.substr(0, length));
        bytes_.remove_prefix(length);
        return text;
    }

    /// UTF-8 of up to `most` characters: ASCII, kana, kanji, what MMD's code page has besides, and the rest.
    std::string text(int most) {
        std::string out;
        for (int left = integer(0, most); left > 0; --left) append(out, code_point());
        return out;
    }

  private:
    std::uint32_t code_point() {
        switch (byte() % 6) {
            case 0:
            case 1:
                return static_cast<std::uint32_t>(integer(0, 0x7f));
            case 2:
                return static_cast<std::uint32_t>(integer(0x3000, 0x30ff));
            case 3:
                return static_cast<std::uint32_t>(integer(0x4e00, 0x9fff));
            case 4:
                return static_cast<std::uint32_t>(integer(0x80, 0xd7ff));
            default:
                return 0xe000 + static_cast<std::uint32_t>(integer(0, 65'535)) * 16;  // up to 0x10dff0
        }
    }

    static void append(std::string& out, const std::uint32_t point) {
        const auto tail = [&](const int shift) { out += static_cast<char>(0x80 | (point >> shift & 0x3f)); };
        if (point < 0x80) {
            out += static_cast<char>(point);
        } else if (point < 0x800) {
            out += static_cast<char>(0xc0 | point >> 6);
            tail(0);
        } else if (point < 0x10000) {
            out += static_cast<char>(0xe0 | point >> 12);
            tail(6), tail(0);
        } else {
            out += static_cast<char>(0xf0 | point >> 18);
            tail(12), tail(6), tail(0);
        }
    }

    std::string_view bytes_;
};

}  // namespace tuftwave::server::fuzz
