#include "http/debt.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <thread>

namespace tuftwave::server {
namespace {

struct DebtTest : testing::Test {
    Poller poller;
    std::shared_ptr<Mailbox> mailbox = std::make_shared<Mailbox>(poller);
    std::shared_ptr<const Library> library = std::make_shared<const Library>();
    std::shared_ptr<std::atomic<bool>> draining = std::make_shared<std::atomic<bool>>(false);

    std::unique_ptr<Debt> owe(const bool closes = false) {
        return std::make_unique<Debt>(mailbox, library, draining, 7, "GET", closes);
    }
};

TEST_F(DebtTest, IsPaidOnceByAnyThread) {
    const auto debt = owe();
    std::thread([&] {
        debt->pay({200, "text/plain", "one", {}});
        debt->pay({200, "text/plain", "two", {}});
    }).join();
    const std::list<Letter> letters = mailbox->collect();
    ASSERT_EQ(letters.size(), 1u);
    EXPECT_EQ(letters.front().connection, 7u);
    EXPECT_EQ(letters.front().message.body, "one");
    EXPECT_FALSE(letters.front().closes);
}

TEST_F(DebtTest, ThatIsForgottenSaysSo) {
    owe().reset();
    const std::list<Letter> letters = mailbox->collect();
    ASSERT_EQ(letters.size(), 1u);
    EXPECT_TRUE(letters.front().message.head.empty());
}

TEST_F(DebtTest, SaysCloseWhileTheListenerDrains) {
    const auto debt = owe();
    *draining = true;
    debt->pay({200, "text/plain", "", {}});
    const std::list<Letter> letters = mailbox->collect();
    EXPECT_TRUE(letters.front().closes);
    EXPECT_NE(letters.front().message.head.find("Connection: close\r\n"), std::string::npos);
}

TEST_F(DebtTest, WakesWhoWaits) {
    ASSERT_TRUE(mailbox->may_sleep());
    owe().reset();
    const auto begin = std::chrono::steady_clock::now();
    poller.wait(std::chrono::seconds(20), [](const Event&) {});
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST_F(DebtTest, WhoHasLettersMustNotWait) {
    owe().reset();
    EXPECT_FALSE(mailbox->may_sleep());
    EXPECT_EQ(mailbox->collect().size(), 1u);
    EXPECT_TRUE(mailbox->may_sleep());
}

TEST_F(DebtTest, OutlivesTheListener) {
    const auto debt = owe();
    mailbox->close();
    debt->pay({200, "text/plain", "", {}});  // nobody is woken, nothing breaks
    EXPECT_EQ(mailbox->collect().size(), 1u);
}

}  // namespace
}  // namespace tuftwave::server
