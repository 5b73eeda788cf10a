#pragma once

#include <chrono>
#include <condition_variable>
#include <list>
#include <mutex>
#include <thread>

namespace tuftwave::server {

/// Something whose time can be up.
class Expiring {
  public:
    virtual ~Expiring() = default;
    virtual void expire() noexcept = 0;
};

/// Tells those who wait when their time is up, on a thread of its own. All wait equally long, so who came first is told
/// first. Thread-safe.
class Deadlines {
    struct Entry {
        std::chrono::steady_clock::time_point time;
        Expiring* who;
    };

  public:
    explicit Deadlines(std::chrono::duration<double> patience);
    /// Waits until nobody is watched any more.
    ~Deadlines();
    Deadlines(const Deadlines&) = delete;
    Deadlines& operator=(const Deadlines&) = delete;

    /// As long as this lives, its owner's expire() may be called, once. Ends only when that call has ended.
    class Watch {
      public:
        Watch(Deadlines& deadlines, Expiring& who);
        ~Watch();
        Watch(const Watch&) = delete;
        Watch& operator=(const Watch&) = delete;

      private:
        Deadlines& deadlines_;
        std::list<Entry> entry_;               // empty while it is in the list of all
        std::list<Entry>::iterator position_;  // there
    };

  private:
    void run();

    const std::chrono::steady_clock::duration patience_;
    std::mutex mutex_;
    std::condition_variable wake_, all_gone_;
    std::list<Entry> waiting_, expired_;
    bool stopping_ = false;
    std::thread thread_;
};

}  // namespace tuftwave::server
