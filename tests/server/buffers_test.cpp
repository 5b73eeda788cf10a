#include "memory/buffers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

namespace tuftwave::server::memory {
namespace {

constexpr std::size_t kSize = 3'000'000;

struct Buffers : testing::Test {
    Buffers() { free_idle_buffers(std::chrono::seconds(0)); }
    ~Buffers() override {
        free_idle_buffers(std::chrono::seconds(0));
        keep_at_most(kUsuallyKept);
    }
};

TEST_F(Buffers, HaveTheirSizeAndRoomToGrow) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{100}, kSize}) {
        std::string buffer = take_buffer(size, size + 1'000'000);
        EXPECT_EQ(buffer.size(), size);
        const char* const place = buffer.data();
        buffer.resize(size + 1'000'000);
        EXPECT_EQ(buffer.data(), place);
    }
    EXPECT_EQ(take_buffer(50, 0).size(), 50u);
}

TEST_F(Buffers, ComeBackToWhoeverTakesOneNext) {
    std::string buffer = take_buffer(kSize, kSize);
    const char* const place = buffer.data();
    give_back(std::move(buffer));
    EXPECT_GE(kept_bytes(), kSize);
    const std::string again = take_buffer(kSize - 500'000, kSize - 100'000);
    EXPECT_EQ(again.data(), place);
    EXPECT_EQ(again.size(), kSize - 500'000);
    EXPECT_EQ(kept_bytes(), 0u);
}

TEST_F(Buffers, ThatAreTooSmallOrFarTooLargeAreFreedForAFreshOne) {
    for (const std::size_t other : {kSize + 1'000, kSize / 2 - 1'000}) {
        give_back(take_buffer(kSize, kSize));
        EXPECT_EQ(take_buffer(1'000, other).size(), 1'000u);
        EXPECT_EQ(kept_bytes(), 0u) << other;
    }
}

TEST_F(Buffers, SmallOnesAreNotKept) {
    give_back(take_buffer(1'000, kLeastBuffer / 2));
    give_back(std::string());
    EXPECT_EQ(kept_bytes(), 0u);
    give_back(take_buffer(kSize, kSize));
    take_buffer(1'000, 1'000);
    EXPECT_GE(kept_bytes(), kSize) << "a small one frees no large one";
}

TEST_F(Buffers, NoMoreAreKeptThanAllowed) {
    for (const std::size_t most : {kUsuallyKept, 4 * kUsuallyKept}) {
        keep_at_most(most);
        for (const std::size_t size : {kSize, most / 3, most}) {
            std::vector<std::string> taken;
            for (int i = 0; i < 10; ++i) taken.push_back(take_buffer(0, size));  // never written: no memory
            for (std::string& buffer : taken) give_back(std::move(buffer));
            EXPECT_LE(kept_bytes(), most);
            EXPECT_GE(kept_bytes(), std::min(4 * size, most / 3)) << size;
            free_idle_buffers(std::chrono::seconds(0));
        }
    }
}

TEST_F(Buffers, AreFreedWhenNobodyTakesThem) {
    give_back(take_buffer(kSize, kSize));
    free_idle_buffers(std::chrono::hours(1));
    EXPECT_GE(kept_bytes(), kSize);
    free_idle_buffers(std::chrono::seconds(0));
    EXPECT_EQ(kept_bytes(), 0u);
}

TEST_F(Buffers, AreOneThreadsAtATime) {
    std::vector<std::thread> threads;
    for (char mark = 'a'; mark < 'e'; ++mark)
        threads.emplace_back([mark] {
            for (int i = 0; i < 50; ++i) {
                std::string buffer = take_buffer(kLeastBuffer, kLeastBuffer);
                buffer.assign(buffer.size(), mark);
                EXPECT_EQ(buffer.find_first_not_of(mark), std::string::npos);
                give_back(std::move(buffer));
            }
        });
    for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace tuftwave::server::memory
