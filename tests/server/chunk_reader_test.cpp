#include "http/chunk_reader.hpp"

#include <gtest/gtest.h>

namespace tuftwave::server {
namespace {

using Step = ChunkReader::Step;

constexpr std::size_t kMost = 100;

struct Read {
    Step step;
    std::string body, left;
};

/// Reads a text in pieces of `piece` bytes.
Read read(const std::string& text, const std::size_t piece) {
    ChunkReader reader;
    Read result{Step::kWantsMore, "", ""};
    for (std::size_t at = 0; at < text.size(); at += piece) {
        std::string_view bytes = std::string_view(text).substr(at, piece);
        result.step = reader.take(bytes, result.body, kMost);
        if (result.step == Step::kWantsMore) continue;
        result.left = std::string(bytes) + text.substr(std::min(text.size(), at + piece));
        break;
    }
    return result;
}

TEST(ChunkReader, JoinsChunksHoweverTheyAreSplit) {
    const std::string text = "3\r\nabc\r\n00A;x=y\r\n0123456789\r\n0\r\nT: 1\r\n\r\nnext";
    for (std::size_t piece = 1; piece <= text.size(); ++piece) {
        const Read got = read(text, piece);
        EXPECT_EQ(got.step, Step::kDone) << piece;
        EXPECT_EQ(got.body, "abc0123456789") << piece;
        EXPECT_EQ(got.left, "next") << piece;
    }
}

TEST(ChunkReader, WaitsForTheEnd) {
    for (const char* text : {"", "3", "3\r\n", "3\r\nab", "3\r\nabc", "3\r\nabc\r\n", "3\r\nabc\r\n0\r\n"})
        EXPECT_EQ(read(text, 1).step, Step::kWantsMore) << text;
}

TEST(ChunkReader, WhatIsNotWellFormedIsBroken) {
    const std::string endless(1'000, '0');
    for (const std::string text :
         {"g\r\n", "-1\r\n", "+1\r\n", "0x1\r\n", "\r\n", " 1\r\n", "1 \r\n", "1\n", "1\r\nab\r\n", "1\r\na0\r\n",
          "1;\x01\r\n", "10000000000000000\r\n", "1\r\na\n\r\n", endless.c_str()})
        for (const std::size_t piece : {std::size_t{1}, text.size()})
            EXPECT_EQ(read(text, piece).step, Step::kBroken) << text;
}

TEST(ChunkReader, TrailersEnd) {
    std::string text = "0\r\n";
    for (int i = 0; i < 16; ++i) text += "T: 1\r\n";
    EXPECT_EQ(read(text + "\r\n", 9).step, Step::kDone);
    EXPECT_EQ(read(text + "T: 1\r\n", 9).step, Step::kBroken);
}

TEST(ChunkReader, MoreThanAllowedIsRefusedBeforeItIsRead) {
    const std::string half(kMost / 2, 'x');
    EXPECT_EQ(read("32\r\n" + half + "\r\n32\r\n" + half + "\r\n0\r\n\r\n", 7).body.size(), kMost);
    const Read over = read("32\r\n" + half + "\r\n33\r\nx", 1000);
    EXPECT_EQ(over.step, Step::kTooLong);
    EXPECT_EQ(over.body, half);
    EXPECT_EQ(read("ffffffffffffffff\r\n", 3).step, Step::kTooLong);
}

}  // namespace
}  // namespace tuftwave::server
