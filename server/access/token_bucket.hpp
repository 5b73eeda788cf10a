#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <optional>

namespace tuftwave::server {

/// The time now; a function, so that tests need not wait.
using Now = std::function<std::chrono::steady_clock::time_point()>;

/// The share of one key, in units of one millisecond of a worker's time.
///
/// Paid afterwards, by the clock: what a request costs is measured and not guessed from what it looks like, since a
/// guess is an invitation to find the request that looks cheap and is dear. A request is let in while the balance is
/// positive and pays a small deposit at once, so that many at the same moment do not all see the same balance; what
/// it has really cost is taken when it is known. The balance may so fall below zero, by what was under way, and its
/// owner waits until the rate has paid it back. Over any long time nobody gets more than burst + rate x time and
/// what was under way at its end. Thread-safe.
class TokenBucket {
  public:
    /// @param rate   units a second; 0: nobody is refused and nothing is counted
    /// @param burst  units, at least 1: the balance at the start, and the most it ever is
    TokenBucket(double rate, double burst, Now now);

    /// Takes the deposit where the balance is positive.
    /// @return  nothing if the request is let in, else the seconds, 0 or more, until the balance is above zero again
    std::optional<double> admit(double deposit);

    /// Takes what a request has cost. @param units  0 or more
    void charge(double units);

  private:
    void fill();

    const double rate_, burst_;
    const Now now_;
    std::mutex mutex_;
    double balance_;
    std::chrono::steady_clock::time_point filled_;
};

}  // namespace tuftwave::server
