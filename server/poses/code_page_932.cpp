#include "poses/code_page_932.hpp"

#include <cstdint>
#include <unordered_map>

#include "assets/assets.hpp"

namespace tuftwave::server::poses {
namespace {

constexpr char32_t kFirstHalfKana = 0xFF61, kLastHalfKana = 0xFF9F;  // whose codes run on from a byte of 0xA1
constexpr char32_t kFirstHalfKanaCode = 0xA1;
constexpr std::uint16_t kFirstTrail = 0x40;

/// Takes the next character off a text. @return  0 where it is no UTF-8
char32_t next_character(std::string_view& text) {
    const auto byte = [&](std::size_t at) {
        return at < text.size() ? static_cast<unsigned char>(text[at]) : static_cast<unsigned char>(0);
    };
    const unsigned char lead = byte(0);
    const std::size_t length = lead < 0x80 ? 1 : lead >> 5 == 6 ? 2 : lead >> 4 == 14 ? 3 : lead >> 3 == 30 ? 4 : 0;
    if (length == 0 || length > text.size()) return 0;
    char32_t character = length == 1 ? lead : lead & (0x7FU >> length);
    for (std::size_t at = 1; at < length; ++at) {
        if (byte(at) >> 6 != 2) return 0;
        character = character << 6 | (byte(at) & 0x3FU);
    }
    text.remove_prefix(length);
    return character;
}

using Codes = std::unordered_map<char32_t, std::uint16_t>;

/// Reads the table: a line for each first byte, as two hexadecimal digits and a blank, then the character of every
/// second byte from 0x40 on, with a full stop where there is none. A character that has several codes stands only where
/// Windows writes it: in IBM's extension rather than in NEC's copy of that.
Codes read_table() {
    Codes codes;
    std::string_view table = asset("code_page_932.txt").value_or("");
    while (!table.empty()) {
        std::string_view line = table.substr(0, table.find('\n'));
        table.remove_prefix(line.size() + 1);
        const auto lead = static_cast<std::uint16_t>(std::stoi(std::string(line.substr(0, 2)), nullptr, 16));
        line.remove_prefix(3);
        for (std::uint16_t trail = kFirstTrail; !line.empty(); ++trail) {
            const char32_t character = next_character(line);
            if (character != '.') codes.emplace(character, static_cast<std::uint16_t>(lead << 8 | trail));
        }
    }
    return codes;
}

}  // namespace

std::optional<std::string> to_code_page_932(std::string_view utf8) {
    static const Codes codes = read_table();
    std::string encoded;
    while (!utf8.empty()) {
        const char32_t character = next_character(utf8);
        if (character < 0x20 || character == 0x7F) return {};
        if (character < 0x80) {
            encoded.push_back(static_cast<char>(character));
        } else if (character >= kFirstHalfKana && character <= kLastHalfKana) {
            encoded.push_back(static_cast<char>(character - kFirstHalfKana + kFirstHalfKanaCode));
        } else {
            const auto found = codes.find(character);
            if (found == codes.end()) return {};
            encoded.push_back(static_cast<char>(found->second >> 8));
            encoded.push_back(static_cast<char>(found->second & 0xFF));
        }
    }
    return encoded;
}

}  // namespace tuftwave::server::poses
