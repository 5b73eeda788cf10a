#include "poses/code_page_932.hpp"

#include <gtest/gtest.h>
#include <iconv.h>

#include <string>
#include <utility>

namespace tuftwave::server::poses {
namespace {

TEST(CodePage932, EncodesWhatBonesAreCalled) {
    const std::pair<const char*, const char*> cases[] = {
        {"", ""},
        {"hair_A_01", "hair_A_01"},
        {"前髪", "\x91\x4f\x94\xaf"},
        {"ツインテ左", "\x83\x63\x83\x43\x83\x93\x83\x65\x8d\xb6"},
        {"ﾓﾐｱｹﾞ", "\xd3\xd0\xb1\xb9\xde"},
        {"髪①～", "\x94\xaf\x87\x40\x81\x60"},
        {"髙", "\xfb\xfc"},
    };
    for (const auto& [text, bytes] : cases) EXPECT_EQ(to_code_page_932(text), bytes) << text;
}

TEST(CodePage932, RefusesWhatItHasNoCodeFor) {
    for (const char* const text :
         {"é", "髪é", "😀", "\x01", "a\nb", "\x7f", "\xc2\x80", "\xff", "\xe5\x89", "\xe5\x89x", "\xc0\x80"})
        EXPECT_FALSE(to_code_page_932(text)) << text;
    EXPECT_FALSE(to_code_page_932(std::string("a\0b", 3)));
}

/// A character as UTF-8. @param code  from 0x800 to 0xFFFF
std::string utf8_of(unsigned code) {
    return {static_cast<char>(0xE0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 0x3F)),
            static_cast<char>(0x80 | (code & 0x3F))};
}

TEST(CodePage932, IsReadBackByTheSystemsOwnDecoder) {
    const iconv_t decoder = iconv_open("UTF-8", "CP932");
    if (decoder == reinterpret_cast<iconv_t>(-1)) GTEST_SKIP() << "this system's iconv does not know the code page";
    int encoded = 0;
    for (unsigned code = 0x800; code <= 0xFFFF; ++code) {
        auto bytes = to_code_page_932(utf8_of(code));
        if (!bytes) continue;
        ++encoded;
        char back[8] = {};
        char* from = bytes->data();
        char* to = back;
        std::size_t left = bytes->size(), room = sizeof back;
        iconv(decoder, &from, &left, &to, &room);
        EXPECT_EQ(std::string(back, static_cast<std::size_t>(to - back)), utf8_of(code)) << std::hex << code;
    }
    iconv_close(decoder);
    EXPECT_GT(encoded,
              7'200);  // 7,326 pairs of bytes and 63 half-width letters, less what is below 0x800: Greek, Cyrillic
}

}  // namespace
}  // namespace tuftwave::server::poses
