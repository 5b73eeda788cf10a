#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>

#include "tuftwave/for_each.hpp"

namespace tuftwave::server {

/// A bounded pool of worker threads: it refuses work rather than letting a queue grow, and splits one large request
/// over the workers that have nothing to do. Thread-safe.
class Pool {
  public:
    struct Stats {
        int workers = 0;
        int busy = 0;              ///< running a job, or helping a loop
        std::size_t queued = 0;    ///< accepted, not begun
        std::size_t capacity = 0;  ///< jobs that may wait while every worker is busy
        bool is_full = false;      ///< whether submit() would refuse
        double saturation = 0;     ///< 0: nothing to do; 0.5: every worker is busy; 1: full
        std::size_t failed = 0;    ///< jobs that threw, since the start: each is a bug
    };

    /// @param workers         threads, at least 1
    /// @param queue_capacity  jobs that may wait while every worker is busy
    /// @param longest_wait    and the time that they may be expected to wait, by what jobs took lately; an eighth of it
    ///                        once the queue has stood for that long. One for each worker may wait in any case.
    Pool(int workers, std::size_t queue_capacity, std::chrono::duration<double> longest_wait = std::chrono::hours(1));
    ~Pool();
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    /// Hands a job to the next free worker. A job must not throw; one that does is counted and forgotten.
    /// @return  false if the queue is full or the pool is stopping: the job will not run
    [[nodiscard]] bool submit(std::function<void()> job);

    /// Spreads a loop over idle workers. The caller takes part, so a loop ends even if every worker is busy, also when
    /// it is started by a worker or after stop(). Idle workers help a running loop before they begin a queued job.
    /// If indices throw, the exception of the lowest one is rethrown, as if they ran in order; later ones may be
    /// skipped.
    const ForEach& for_each() const;

    Stats stats() const;

    /// Takes no new jobs, runs those that were accepted and joins the workers. Not to be called by a job.
    void stop();

  private:
    class Workers;
    std::unique_ptr<Workers> workers_;
};

}  // namespace tuftwave::server
