#include "memory/reserve.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <new>

#include "memory/buffers.hpp"

namespace tuftwave::server::memory {
namespace {

constexpr std::size_t kTooMuch = std::size_t{1} << 46;  // no machine has so many addresses left

/// Nothing that other tests have given back is kept.
struct Reserve : testing::Test {
    Reserve() { free_idle_buffers(std::chrono::seconds(0)); }
};

TEST_F(Reserve, IsThereOnceItIsHeld) {
    hold_reserve();
    EXPECT_TRUE(has_reserve());
    hold_reserve();
    EXPECT_TRUE(has_reserve());
}

TEST_F(Reserve, IsGivenUpWhereMemoryEndsAndCanBeHeldAgain) {
    hold_reserve();
    const std::new_handler handler = std::get_new_handler();
    ASSERT_NE(handler, nullptr);
    handler();  // as operator new does: there is something to be had, and it may try again
    EXPECT_FALSE(has_reserve());
    EXPECT_THROW(handler(), std::bad_alloc);
    hold_reserve();
    EXPECT_TRUE(has_reserve());
    EXPECT_NO_THROW(handler());
    hold_reserve();
}

TEST_F(Reserve, OutlastsTheBuffersThatAreKept) {
    hold_reserve();
    give_back(take_buffer(kLeastBuffer, kLeastBuffer));
    ASSERT_GT(kept_bytes(), 0u);
    std::get_new_handler()();
    EXPECT_EQ(kept_bytes(), 0u);
    EXPECT_TRUE(has_reserve());
}

TEST_F(Reserve, HasAHalfForWhoLetsGoAfterTheOtherOneIsUsedUp) {
    struct LetsGo {
        ~LetsGo() { EXPECT_NO_THROW(std::get_new_handler()()); }
    };
    hold_reserve();
    std::get_new_handler()();
    EXPECT_THROW(std::get_new_handler()(), std::bad_alloc);
    try {
        const LetsGo passed;
        throw std::bad_alloc();
    } catch (const std::bad_alloc&) {
    }
    EXPECT_THROW(std::get_new_handler()(), std::bad_alloc);
    hold_reserve();
    EXPECT_TRUE(has_reserve());
}

TEST_F(Reserve, ATooLargeAllocationStillFails) {
    if (TUFTWAVE_SANITIZED) GTEST_SKIP() << "a sanitizer's operator new ends the process";
    hold_reserve();
    EXPECT_THROW(::operator delete(::operator new(kTooMuch)), std::bad_alloc);
    EXPECT_FALSE(has_reserve());
    hold_reserve();
}

}  // namespace
}  // namespace tuftwave::server::memory
