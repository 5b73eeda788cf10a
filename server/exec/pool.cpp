#include "exec/pool.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace tuftwave::server {
namespace {

/// Claims per thread that a long loop is cut into: enough to even out slow parts, few enough to leave the counter cold.
constexpr std::size_t kClaimsPerThread = 16;

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;
/// How much one job counts in the mean of what jobs take.
constexpr double kShareOfOne = 1.0 / 16;
/// What is left of the longest wait while the queue does not empty.
constexpr double kShareUnderOverload = 1.0 / 8;
constexpr std::size_t kAlwaysPerWorker = 1;

/// One running loop. It lives on its caller's stack and stays until every helper has left.
class Loop {
  public:
    Loop(const std::size_t count, const std::size_t chunk, const std::function<void(std::size_t)>& job)
        : count_(count), chunk_(chunk), job_(job), first_failure_(count) {}

    bool has_unclaimed() const { return next_.load(std::memory_order_relaxed) < limit(); }

    /// Claims and runs indices until none are left. Only indices above the lowest failure are skipped, and claims are
    /// handed out in order, so the lowest failure does not depend on the number of threads.
    void take_part() {
        while (has_unclaimed()) {
            const std::size_t begin = next_.fetch_add(chunk_, std::memory_order_relaxed);
            const std::size_t end = std::min(count_, begin + chunk_);
            for (std::size_t i = begin; i < end && i < limit(); ++i) run(i);
        }
    }

    void rethrow_failure() const {
        if (failure_) std::rethrow_exception(failure_);
    }

    int helpers = 0;                   ///< guarded by the pool's mutex
    std::condition_variable all_left;  ///< with the pool's mutex

  private:
    std::size_t limit() const { return first_failure_.load(std::memory_order_relaxed); }

    void run(const std::size_t index) {
        try {
            job_(index);
        } catch (...) {
            const std::lock_guard lock(failure_mutex_);
            if (index >= limit()) return;
            first_failure_.store(index, std::memory_order_relaxed);
            failure_ = std::current_exception();
        }
    }

    const std::size_t count_, chunk_;
    const std::function<void(std::size_t)>& job_;
    std::atomic<std::size_t> next_{0};
    std::atomic<std::size_t> first_failure_;
    std::mutex failure_mutex_;
    std::exception_ptr failure_;
};

}  // namespace

class Pool::Workers final : public ForEach {
  public:
    Workers(const int count, const std::size_t capacity, const Seconds longest_wait)
        : count_(std::max(count, 1)), capacity_(capacity), longest_wait_(longest_wait) {
        threads_.reserve(static_cast<std::size_t>(count_));
        for (int i = 0; i < count_; ++i) threads_.emplace_back([this] { work(); });
    }

    bool submit(std::function<void()> job) {
        {
            const std::lock_guard lock(mutex_);
            if (stopping_ || is_full()) return false;
            if (jobs_.empty() && Clock::now() - emptied_ > longest_wait_ * kShareUnderOverload)
                standing_since_ = Clock::now();  // behind a calm; a queue that empties for a moment still stands
            jobs_.push_back(std::move(job));
        }
        wake_.notify_one();
        return true;
    }

    void operator()(const std::size_t count, const std::function<void(std::size_t)>& job) const override {
        const std::size_t shares = (static_cast<std::size_t>(count_) + 1) * kClaimsPerThread;
        Loop loop(count, std::max<std::size_t>(1, count / shares), job);
        if (count > 1) offer(loop);
        loop.take_part();
        if (count > 1) withdraw(loop);
        loop.rethrow_failure();
    }

    Stats stats() const {
        const std::lock_guard lock(mutex_);
        const double queue = std::max(static_cast<double>(jobs_.size()) / static_cast<double>(capacity_),
                                      expected_wait() / longest_wait());
        const double saturation = is_full() ? 1 : (static_cast<double>(busy_) / count_ + std::min(queue, 1.0)) / 2;
        return {count_, busy_, jobs_.size(), capacity_, is_full(), saturation, failed_};
    }

    void stop() {
        std::vector<std::thread> threads;
        {
            const std::lock_guard lock(mutex_);
            stopping_ = true;
            threads.swap(threads_);
        }
        wake_.notify_all();
        for (std::thread& thread : threads) thread.join();
    }

  private:
    /// A queue is measured in time, not in jobs: many small ones may wait as long as one large one. The mutex is held.
    bool is_full() const {
        const std::size_t idle = static_cast<std::size_t>(count_ - busy_);
        const std::size_t fewest = static_cast<std::size_t>(count_) * kAlwaysPerWorker;
        const bool is_short = expected_wait() < longest_wait();
        return jobs_.size() >= idle + (is_short ? capacity_ : std::min(capacity_, fewest));
    }

    /// A burst may wait. A queue that has not been empty for that long is no burst: more comes than can be done, and
    /// whoever waits only waits behind others. The mutex is held.
    Seconds longest_wait() const {
        const bool is_overload = !jobs_.empty() && Clock::now() - standing_since_ > longest_wait_;
        return is_overload ? longest_wait_ * kShareUnderOverload : longest_wait_;
    }

    /// Of a job that would come now. The mutex is held.
    Seconds expected_wait() const { return mean_job_ * static_cast<double>(jobs_.size()) / count_; }

    void offer(Loop& loop) const {
        {
            const std::lock_guard lock(mutex_);
            loops_.push_back(&loop);
            if (busy_ == count_) return;
        }
        wake_.notify_all();
    }

    void withdraw(Loop& loop) const {
        std::unique_lock lock(mutex_);
        std::erase(loops_, &loop);
        loop.all_left.wait(lock, [&] { return loop.helpers == 0; });
    }

    /// The loop with work left that the fewest workers help. The mutex is held.
    Loop* neediest_loop() const {
        Loop* found = nullptr;
        for (Loop* loop : loops_) {
            if (loop->has_unclaimed() && (!found || loop->helpers < found->helpers)) found = loop;
        }
        return found;
    }

    void work() {
        std::unique_lock lock(mutex_);
        for (;;) {
            if (Loop* loop = neediest_loop()) {
                help(*loop, lock);
            } else if (!jobs_.empty()) {
                run_next_job(lock);
            } else if (stopping_) {
                return;
            } else {
                wake_.wait(lock);
            }
        }
    }

    void help(Loop& loop, std::unique_lock<std::mutex>& lock) {
        ++busy_;
        ++loop.helpers;
        lock.unlock();
        const auto begin = Clock::now();
        loop.take_part();
        const Seconds took = Clock::now() - begin;
        lock.lock();
        --busy_;
        help_ += took;
        if (--loop.helpers == 0) loop.all_left.notify_all();
    }

    void run_next_job(std::unique_lock<std::mutex>& lock) {
        ++busy_;
        std::function<void()> job = std::move(jobs_.front());
        jobs_.pop_front();
        if (jobs_.empty()) emptied_ = Clock::now();
        lock.unlock();
        bool threw = false;
        const auto begin = Clock::now();
        try {
            job();
        } catch (...) {  // nobody waits for it: the process must outlive a bug in one job
            threw = true;
        }
        job = nullptr;  // what it captured goes before the lock is taken
        const Seconds took = Clock::now() - begin;
        lock.lock();
        --busy_;
        mean_job_ += (took + std::exchange(help_, Seconds(0)) - mean_job_) * kShareOfOne;
        if (threw) ++failed_;
    }

    const int count_;
    const std::size_t capacity_;
    const Seconds longest_wait_;
    mutable std::mutex mutex_;  // guards everything below
    mutable std::condition_variable wake_;
    mutable std::vector<Loop*> loops_;
    std::deque<std::function<void()>> jobs_;
    std::vector<std::thread> threads_;
    int busy_ = 0;
    Seconds mean_job_{0};                         // of all workers' time
    Seconds help_{0};                             // since a job ended
    Clock::time_point standing_since_, emptied_;  // the queue
    std::size_t failed_ = 0;
    bool stopping_ = false;
};

Pool::Pool(const int workers, const std::size_t queue_capacity, const Seconds longest_wait)
    : workers_(std::make_unique<Workers>(workers, queue_capacity, longest_wait)) {}

Pool::~Pool() { stop(); }

bool Pool::submit(std::function<void()> job) { return workers_->submit(std::move(job)); }

const ForEach& Pool::for_each() const { return *workers_; }

Pool::Stats Pool::stats() const { return workers_->stats(); }

void Pool::stop() { workers_->stop(); }

}  // namespace tuftwave::server
