#include "service/deadlines.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <memory>
#include <vector>

namespace tuftwave::server {
namespace {

using namespace std::chrono_literals;

struct Counted final : Expiring {
    std::latch expired{1};
    std::atomic<int> times = 0;
    void expire() noexcept override {
        if (++times == 1) expired.count_down();
    }
};

TEST(Deadlines, TellsEachOnceWhenItsTimeIsUp) {
    Deadlines deadlines(5ms);
    std::vector<std::unique_ptr<Counted>> all;
    std::vector<std::unique_ptr<Deadlines::Watch>> watches;
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < 20; ++i) {
        all.push_back(std::make_unique<Counted>());
        watches.push_back(std::make_unique<Deadlines::Watch>(deadlines, *all.back()));
    }
    for (const auto& each : all) each->expired.wait();
    EXPECT_GE(std::chrono::steady_clock::now() - begin, 5ms);
    watches.clear();
    for (const auto& each : all) EXPECT_EQ(each->times, 1);
}

TEST(Deadlines, WhoIsNoLongerWatchedIsNotTold) {
    Deadlines deadlines(20ms);
    Counted gone, stays;
    const Deadlines::Watch watch(deadlines, stays);
    { const Deadlines::Watch ended(deadlines, gone); }
    stays.expired.wait();
    const Deadlines::Watch again(deadlines, stays);  // its time comes behind that of the one that has gone
    while (stays.times < 2) std::this_thread::yield();
    EXPECT_EQ(gone.times, 0);
}

}  // namespace
}  // namespace tuftwave::server
