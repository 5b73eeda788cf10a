#include "access/token_bucket.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <thread>
#include <vector>

namespace tuftwave::server {
namespace {

/// A clock that stands still until it is set on.
class Clock {
  public:
    Now now() {
        return [this] { return time_; };
    }
    void pass(const double seconds) {
        time_ +=
            std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds));
    }

  private:
    std::chrono::steady_clock::time_point time_{};
};

TEST(TokenBucket, LetsInWhileTheBalanceIsPositive) {
    Clock clock;
    TokenBucket bucket(10, 3, clock.now());
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(bucket.admit(1)) << i;
    EXPECT_EQ(bucket.admit(1), 0.0);  // at zero, not below: any moment will do
    clock.pass(0.1);
    EXPECT_FALSE(bucket.admit(1));
    EXPECT_TRUE(bucket.admit(1));
}

TEST(TokenBucket, IsPaidAfterwardsAndSaysWhenItIsPositiveAgain) {
    Clock clock;
    TokenBucket bucket(10, 3, clock.now());
    EXPECT_FALSE(bucket.admit(1));
    bucket.charge(52);
    EXPECT_EQ(bucket.admit(1), 5.0);
    clock.pass(4);
    EXPECT_EQ(bucket.admit(1), 1.0);
    clock.pass(1.125);
    EXPECT_FALSE(bucket.admit(1));
}

TEST(TokenBucket, ARefusalCostsNothing) {
    Clock clock;
    TokenBucket bucket(10, 3, clock.now());
    bucket.charge(13);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(bucket.admit(1), 1.0);
}

TEST(TokenBucket, NeverHoldsMoreThanItsBurst) {
    Clock clock;
    TokenBucket bucket(10, 3, clock.now());
    clock.pass(1e6);
    bucket.charge(3);
    EXPECT_TRUE(bucket.admit(1));
}

TEST(TokenBucket, ADepositMayBeLargerThanTheBalance) {
    Clock clock;
    TokenBucket bucket(1, 2, clock.now());
    EXPECT_FALSE(bucket.admit(1'000));
    EXPECT_EQ(bucket.admit(1), 998.0);
}

TEST(TokenBucket, WithoutARateNobodyIsRefused) {
    Clock clock;
    TokenBucket bucket(0, 1, clock.now());
    for (int i = 0; i < 10; ++i) {
        bucket.charge(1e9);
        EXPECT_FALSE(bucket.admit(1e9));
    }
}

TEST(TokenBucket, AClockThatGoesBackGivesNothing) {
    Clock clock;
    clock.pass(100);
    TokenBucket bucket(10, 3, clock.now());
    bucket.charge(13);
    clock.pass(-50);
    EXPECT_EQ(bucket.admit(1), 1.0);
    clock.pass(50);
    EXPECT_EQ(bucket.admit(1), 1.0) << "the same time was paid twice";
}

/// The clock is read where the balance is changed: whoever comes in meanwhile would be seen here.
TEST(TokenBucket, OneThreadAtATimeChangesTheBalance) {
    std::atomic<int> inside = 0, most = 0;
    const auto now = [&] {
        const int here = ++inside;
        if (here > most) most = here;
        for (int i = 0; i < 10; ++i) std::this_thread::yield();
        --inside;
        return std::chrono::steady_clock::time_point{};
    };
    TokenBucket bucket(1, 1'000, now);
    std::latch start(4);
    std::atomic<int> admitted = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            start.arrive_and_wait();
            for (int k = 0; k < 500; ++k) admitted += bucket.admit(1) ? 0 : 1;
            for (int k = 0; k < 100; ++k) bucket.charge(0);
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(admitted, 1'000);
    EXPECT_EQ(most, 1);
}

}  // namespace
}  // namespace tuftwave::server
