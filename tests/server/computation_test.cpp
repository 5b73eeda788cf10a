#include "service/computation.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tuftwave::server {
namespace {

struct ComputationTest : testing::Test {
    std::stop_source stop;
    std::vector<Computation::Outcome> outcomes;
    Computation computation{stop, [this](Computation::Outcome outcome) { outcomes.push_back(std::move(outcome)); }};
};

TEST_F(ComputationTest, IsAnsweredByItsWorker) {
    EXPECT_TRUE(computation.start());
    EXPECT_FALSE(computation.start());
    computation.finish(Response{200, "", "done", {}});
    computation.expire();
    ASSERT_EQ(outcomes.size(), 1u);
    EXPECT_EQ(std::get<Response>(*outcomes[0].answer).body, "done");
    EXPECT_FALSE(outcomes[0].is_late);
}

TEST_F(ComputationTest, ThatNeverStartedIsAnsweredByItsDeadline) {
    computation.expire();
    EXPECT_FALSE(computation.start());
    ASSERT_EQ(outcomes.size(), 1u);
    EXPECT_FALSE(outcomes[0].answer);
    EXPECT_TRUE(outcomes[0].is_late);
    EXPECT_TRUE(stop.stop_requested());
}

TEST_F(ComputationTest, ThatRunsIsAskedToStopAndAnsweredWhenItHas) {
    EXPECT_TRUE(computation.start());
    computation.expire();
    EXPECT_TRUE(computation.stop_token().stop_requested());
    EXPECT_TRUE(outcomes.empty());
    computation.finish(Problem{ProblemCode::kDeadline, "", {}, {}});
    ASSERT_EQ(outcomes.size(), 1u);
    EXPECT_TRUE(outcomes[0].is_late);
}

}  // namespace
}  // namespace tuftwave::server
