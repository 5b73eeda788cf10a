#pragma once

#include <cstddef>
#include <functional>

namespace tuftwave {

/// Runs a job for every index. Core owns no threads: whoever calls it hands in how work is spread.
/// A job writes only to its own index's place, so the result does not depend on order or thread count.
class ForEach {
  public:
    virtual ~ForEach() = default;

    /// Calls job(0) .. job(count - 1), each exactly once, and returns when all have ended.
    virtual void operator()(std::size_t count, const std::function<void(std::size_t)>& job) const = 0;
};

/// One after the other, on the calling thread.
class InOrder final : public ForEach {
  public:
    void operator()(std::size_t count, const std::function<void(std::size_t)>& job) const override {
        for (std::size_t i = 0; i < count; ++i) job(i);
    }
};

}  // namespace tuftwave
