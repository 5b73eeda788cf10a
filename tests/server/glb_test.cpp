#include "character/glb.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace tuftwave::server::character {
namespace {

constexpr std::size_t kVersionAt = 4, kLengthAt = 8, kJsonLengthAt = 12, kJsonTypeAt = 16;

std::string number(std::uint32_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFF);
    return bytes;
}

std::string chunk(const std::string& type, const std::string& content) {
    return number(static_cast<std::uint32_t>(content.size())) + type + content;
}

std::string file_of(const std::string& chunks) {
    return "glTF" + number(2) + number(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

const std::string kBin("BIN\0", 4);

/// The smallest file that has all three parts: JSON with padding, binary, and two chunks of others.
std::string whole_file() {
    return file_of(chunk("JSON", "{}  ") + chunk(kBin, "12345678") + chunk("ABCD", "abcd") + chunk("EFGH", ""));
}

Glb parts_of(const std::string& file) {
    const auto split = split_glb(file);
    if (const auto* fault = std::get_if<Fault>(&split)) ADD_FAILURE() << fault->allowed;
    return std::holds_alternative<Glb>(split) ? std::get<Glb>(split) : Glb{};
}

/// What is said of a file, "" if it is taken.
std::string complaint(const std::string& file) {
    const auto split = split_glb(file);
    const auto* fault = std::get_if<Fault>(&split);
    if (fault == nullptr) return "";
    EXPECT_EQ(fault->kind, Fault::Kind::kMalformed);
    EXPECT_EQ(fault->pointer, "");
    return fault->allowed;
}

std::string with(std::string file, std::size_t at, const std::string& bytes) {
    return file.replace(at, bytes.size(), bytes);
}

TEST(Glb, IsTakenApart) {
    const std::string file = whole_file();
    const Glb glb = parts_of(file);
    EXPECT_EQ(glb.json, "{}  ");
    EXPECT_EQ(glb.binary, "12345678");
    EXPECT_EQ(glb.others, chunk("ABCD", "abcd") + chunk("EFGH", ""));
}

TEST(Glb, MayHaveNoBinary) {
    const std::string alone = file_of(chunk("JSON", "{}  "));
    EXPECT_EQ(parts_of(alone).binary, "");
    EXPECT_EQ(parts_of(alone).others, "");
    const std::string followed = file_of(chunk("JSON", "{}  ") + chunk("ABCD", "abcd"));
    EXPECT_EQ(parts_of(followed).binary, "");
    EXPECT_EQ(parts_of(followed).others, chunk("ABCD", "abcd"));
}

TEST(Glb, JoinedAgainIsTheSame) {
    for (const std::string& file :
         {whole_file(), file_of(chunk("JSON", "{}  ")), file_of(chunk("JSON", "{}  ") + chunk("ABCD", "abcd"))}) {
        const Glb glb = parts_of(file);
        EXPECT_EQ(join_glb(glb.json, glb.binary, "", glb.others), file);
    }
}

TEST(Glb, JoiningPadsJsonAndAppendsBytes) {
    const std::string file = join_glb(R"({"a":1})", "1234", "5678", chunk("ABCD", "abcd"));
    EXPECT_EQ(file, file_of(chunk("JSON", R"({"a":1} )") + chunk(kBin, "12345678") + chunk("ABCD", "abcd")));
    EXPECT_EQ(join_glb("{}", "", "5678", ""), file_of(chunk("JSON", "{}  ") + chunk(kBin, "5678")));
}

TEST(Glb, CutAnywhereIsRefused) {
    const std::string file = whole_file();
    for (std::size_t bytes = 0; bytes < file.size(); ++bytes) {
        const std::string cut = file.substr(0, bytes);
        EXPECT_NE(complaint(cut), "") << bytes;
        // With a header that agrees, whole chunks are a whole file.
        if (bytes < kJsonLengthAt) continue;
        const bool is_whole = bytes == 24 || bytes == 40 || bytes == 52;
        EXPECT_EQ(complaint(with(cut, kLengthAt, number(static_cast<std::uint32_t>(bytes)))).empty(), is_whole)
            << bytes;
    }
}

TEST(Glb, EveryLengthIsCheckedAgainstTheFile) {
    const std::string file = whole_file();
    for (const std::size_t at : {kLengthAt, kJsonLengthAt, std::size_t{24}, std::size_t{40}, std::size_t{52}}) {
        for (const std::uint32_t length :
             {1U, 3U, 5U, 64U, 0x7FFF'FFFCU, 0x8000'0000U, 0xFFFF'FFF8U, 0xFFFF'FFFCU, 0xFFFF'FFFFU}) {
            EXPECT_NE(complaint(with(file, at, number(length))), "") << length << " at " << at;
        }
    }
    EXPECT_NE(complaint(file + "    "), "");
}

TEST(Glb, ChunksStandInTheirOrder) {
    const std::string json = chunk("JSON", "{}  "), binary = chunk(kBin, "1234"), other = chunk("ABCD", "abcd");
    for (const std::string& chunks :
         {std::string(), binary, other, binary + json, other + json, json + json, json + binary + binary,
          json + other + binary, json + binary + json, json + other + json, chunk("JSON", "")}) {
        EXPECT_NE(complaint(file_of(chunks)), "") << chunks;
    }
}

TEST(Glb, SaysWhichVersionItHas) {
    const std::string file = whole_file();
    EXPECT_NE(complaint(with(file, kVersionAt, number(1))).find("version 1"), std::string::npos);
    EXPECT_NE(complaint(with(file, 0, "glTf")).find("does not begin"), std::string::npos);
    EXPECT_NE(complaint(with(file, kJsonTypeAt, "JSOM")).find("must be JSON"), std::string::npos);
    EXPECT_NE(complaint(R"({"asset": {"version": "2.0"}})").find("does not begin"), std::string::npos);
}

TEST(Glb, WithUnalignedChunksIsRefused) {
    EXPECT_NE(complaint(file_of(chunk("JSON", "{}"))).find("multiple of 4"), std::string::npos);
    EXPECT_NE(complaint(file_of(chunk("JSON", "{}  ") + chunk(kBin, "12345"))).find("multiple of 4"),
              std::string::npos);
}

}  // namespace
}  // namespace tuftwave::server::character
