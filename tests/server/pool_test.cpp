#include "exec/pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <latch>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace tuftwave::server {
namespace {

/// Occupies one worker until it is released.
class Occupied {
  public:
    explicit Occupied(Pool& pool) {
        EXPECT_TRUE(pool.submit([this] {
            begun_.count_down();
            release_.wait();
            ended_.count_down();
        }));
        begun_.wait();
    }
    ~Occupied() {
        release_.count_down();
        ended_.wait();
    }

  private:
    std::latch begun_{1}, release_{1}, ended_{1};
};

std::vector<int> visits(const Pool& pool, const std::size_t count) {
    std::vector<int> seen(count, 0);
    pool.for_each()(count, [&](const std::size_t i) { ++seen[i]; });
    return seen;
}

TEST(Pool, EveryIndexRunsExactlyOnce) {
    for (const int workers : {1, 2, 4, 16}) {
        const Pool pool(workers, 4);
        // None, one (which needs no helper), fewer than threads, and enough for chunks of several indices.
        for (const std::size_t count : {0u, 1u, 3u, 10'000u}) {
            EXPECT_EQ(visits(pool, count), std::vector<int>(count, 1))
                << workers << " workers, " << count << " indices";
        }
    }
}

TEST(Pool, LoopsOfSeveralThreadsAtOnceDoNotMix) {
    const Pool pool(2, 4);
    std::vector<std::thread> callers;
    for (int caller = 0; caller < 4; ++caller) {
        callers.emplace_back([&] {
            for (int round = 0; round < 20; ++round) EXPECT_EQ(visits(pool, 500), std::vector<int>(500, 1));
        });
    }
    for (std::thread& caller : callers) caller.join();
}

TEST(Pool, NestedLoopInAJobOfTheOnlyWorkerEnds) {
    Pool pool(1, 4);
    std::vector<int> seen(64, 0);
    std::latch ended(1);
    ASSERT_TRUE(pool.submit([&] {
        pool.for_each()(8, [&](const std::size_t outer) {
            pool.for_each()(8, [&](const std::size_t inner) { ++seen[outer * 8 + inner]; });
        });
        ended.count_down();
    }));
    ended.wait();
    EXPECT_EQ(seen, std::vector<int>(64, 1));
}

TEST(Pool, IdleWorkerHelpsALoop) {
    const Pool pool(1, 1);
    std::latch both_here(2);  // opens only if two threads are inside the loop at once
    pool.for_each()(2, [&](std::size_t) { both_here.arrive_and_wait(); });
}

TEST(Pool, IdleWorkerPrefersALoopToAQueuedJob) {
    Pool pool(1, 1);
    std::atomic<bool> job_ran = false, job_came_first = false;
    std::latch occupied(1), loop_begun(1);
    ASSERT_TRUE(pool.submit([&] {
        occupied.count_down();
        loop_begun.wait();
    }));
    occupied.wait();
    ASSERT_TRUE(pool.submit([&] { job_ran = true; }));
    std::latch both_here(2);
    pool.for_each()(2, [&](std::size_t) {
        if (!loop_begun.try_wait()) loop_begun.count_down();  // only the caller can be here before the worker is free
        if (job_ran) job_came_first = true;
        both_here.arrive_and_wait();
    });
    EXPECT_FALSE(job_came_first);
}

TEST(Pool, RefusesWhenEveryWorkerIsBusyAndTheQueueIsFull) {
    Pool pool(2, 3);
    std::atomic<int> ran = 0;
    {
        const Occupied first(pool), second(pool);
        for (int i = 0; i < 3; ++i) EXPECT_TRUE(pool.submit([&] { ++ran; }));
        EXPECT_FALSE(pool.submit([&] { ran += 100; }));
        const Pool::Stats stats = pool.stats();
        EXPECT_EQ(stats.workers, 2);
        EXPECT_EQ(stats.busy, 2);
        EXPECT_EQ(stats.queued, 3u);
        EXPECT_EQ(stats.capacity, 3u);
    }
    pool.stop();
    EXPECT_EQ(ran, 3);
}

TEST(Pool, FreeWorkersDoNotCountAsAFullQueue) {
    std::latch begun(3), release(1);  // outlive the pool, whose workers may still be leaving them
    Pool pool(3, 0);                  // nothing may wait, but three can begin at once, however slowly they wake
    for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(pool.submit([&] {
            begun.count_down();
            release.wait();
        }));
    }
    begun.wait();
    EXPECT_FALSE(pool.submit([] {}));
    release.count_down();
}

TEST(Pool, LowestExceptionIsRethrownWhateverTheNumberOfWorkers) {
    for (const int workers : {1, 4}) {
        const Pool pool(workers, 4);
        for (int round = 0; round < 50; ++round) {
            try {
                pool.for_each()(1'000, [](const std::size_t i) {
                    if (i >= 300 && i % 7 == 6) throw std::runtime_error(std::to_string(i));
                });
                FAIL() << "nothing was thrown";
            } catch (const std::runtime_error& error) {
                EXPECT_STREQ(error.what(), "300");  // 300 = 42 * 7 + 6
            }
        }
        EXPECT_EQ(visits(pool, 100), std::vector<int>(100, 1)) << "the pool is still of use";
    }
}

TEST(Pool, JobThatThrowsIsCountedAndTheWorkerLivesOn) {
    Pool pool(1, 4);
    std::latch ended(1);
    ASSERT_TRUE(pool.submit([] { throw std::runtime_error("bug"); }));
    ASSERT_TRUE(pool.submit([&] { ended.count_down(); }));
    ended.wait();
    EXPECT_EQ(pool.stats().failed, 1u);
}

TEST(Pool, StopRunsWhatWasAcceptedAndThenRefuses) {
    Pool pool(1, 8);
    std::atomic<int> ran = 0;
    std::latch begun(1), release(1);
    ASSERT_TRUE(pool.submit([&] {
        begun.count_down();
        release.wait();
    }));
    begun.wait();
    for (int i = 0; i < 8; ++i) ASSERT_TRUE(pool.submit([&] { ++ran; }));
    std::thread stopper([&] { pool.stop(); });
    release.count_down();
    stopper.join();
    EXPECT_EQ(ran, 8);
    EXPECT_FALSE(pool.submit([] {}));
    EXPECT_EQ(visits(pool, 10), std::vector<int>(10, 1)) << "the caller alone";
    pool.stop();
}

/// Gives one job after the other, of 5 ms each, so that the pool knows how long jobs take.
void learn_what_jobs_take(Pool& pool) {
    for (int i = 0; i < 40; ++i) {
        std::latch done(1);
        ASSERT_TRUE(pool.submit([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            done.count_down();
        }));
        done.wait();
    }
}

TEST(Pool, QueueIsMeasuredInTime) {
    using namespace std::chrono_literals;
    Pool pool(1, 100, 10ms);
    learn_what_jobs_take(pool);
    const Occupied occupied(pool);
    int accepted = 0;
    while (pool.submit([] {})) ++accepted;
    EXPECT_GE(accepted, 1) << "one for each worker, however long they take";
    EXPECT_LE(accepted, 4);
    EXPECT_TRUE(pool.stats().is_full);
    EXPECT_EQ(pool.stats().saturation, 1);
}

TEST(Pool, QueueThatDoesNotEmptyGetsShorter) {
    using namespace std::chrono_literals;
    Pool pool(1, 100, 400ms);
    learn_what_jobs_take(pool);
    const Occupied occupied(pool);
    for (int i = 0; i < 15; ++i) ASSERT_TRUE(pool.submit([] {}));
    EXPECT_FALSE(pool.stats().is_full) << "a burst";
    std::this_thread::sleep_for(450ms);
    EXPECT_TRUE(pool.stats().is_full) << "no burst any more";
    EXPECT_FALSE(pool.submit([] {}));
}

TEST(Pool, SaturationSaysHowMuchIsLeft) {
    Pool pool(2, 4);
    EXPECT_EQ(pool.stats().saturation, 0);
    const Occupied first(pool), second(pool);
    EXPECT_EQ(pool.stats().saturation, 0.5);
    ASSERT_TRUE(pool.submit([] {}));
    ASSERT_TRUE(pool.submit([] {}));
    EXPECT_EQ(pool.stats().saturation, 0.75);
}

}  // namespace
}  // namespace tuftwave::server
