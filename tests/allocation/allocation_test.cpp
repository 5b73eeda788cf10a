#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <new>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "allocation/failing_allocation.hpp"
#include "api/routes.hpp"
#include "exec/pool.hpp"
#include "memory/reserve.hpp"

namespace tuftwave::server {
namespace {

using failing::Armed;
using failing::Plan;

constexpr std::size_t kAllUpTo = TUFTWAVE_SANITIZED ? 30 : 2'000, kMostBeyond = TUFTWAVE_SANITIZED ? 30 : 200;
constexpr std::size_t kLarge = 16 * 1024;  // bytes; what is smaller could be asked for by a destructor

/// A request of an operation, in one of its formats.
struct Case {
    std::string path, query, file;

    friend void PrintTo(const Case& one, std::ostream* to) {
        *to << one.path << '?' << one.query << " with " << one.file;
    }
};

std::string content_of(const std::string& file) {
    std::ifstream stream(std::string(TUFTWAVE_SOURCE_DIR) + "/" + file, std::ios::binary);
    EXPECT_TRUE(stream) << file;
    return {std::istreambuf_iterator<char>(stream), {}};
}

const Route& route_of(const Request& request) {
    return *std::get<const Route*>(find_route(request.method, request.path));
}

Request request_of(const Case& one) {
    Request request{one.file.empty() ? "GET" : "POST", one.path, {}, {}, one.file.empty() ? "" : content_of(one.file)};
    if (!one.query.empty())
        request.query.emplace_back(one.query.substr(0, one.query.find('=')), one.query.substr(one.query.find('=') + 1));
    if (!one.file.empty())
        request.headers = {{"content-type", route_of(request).takes_file ? "model/gltf-binary" : "application/json"}};
    return request;
}

/// The answer, asked for as the service does; nothing where memory ran out, for which it has an answer of its own.
/// Whatever else is thrown fails the test.
std::optional<Answer> run(const Request& request, const ForEach& for_each) {
    static const Limits limits;
    try {
        memory::hold_reserve();
        return route_of(request).run(request, {limits, for_each, {}});
    } catch (const std::bad_alloc&) {
        return {};
    }
}

void expect_same(const Answer& wanted, const Answer& got) {
    const auto& a = std::get<Response>(wanted);
    const auto* const b = std::get_if<Response>(&got);
    ASSERT_NE(b, nullptr) << "a problem: " << std::get<Problem>(got).detail;
    ASSERT_EQ(a.status, b->status);
    ASSERT_EQ(a.content_type, b->content_type);
    ASSERT_TRUE(a.content() == b->content()) << "other bytes";
    ASSERT_EQ(a.headers, b->headers);
}

/// All numbers below `count` up to kAllUpTo, then some.
std::vector<std::size_t> numbers(const std::size_t count, const std::size_t all_up_to = kAllUpTo) {
    std::vector<std::size_t> chosen(std::min(count, all_up_to));
    std::iota(chosen.begin(), chosen.end(), 0U);
    const std::size_t stride = 1 + (count - chosen.size()) / kMostBeyond;
    for (std::size_t n = chosen.size() + stride / 2; n < count; n += stride) chosen.push_back(n);
    return chosen;
}

struct Outcome {
    std::size_t allocations = 0, answered = 0, refused = 0;
};

/// Makes a request again and again, each time with another of its allocations failing. Whatever happens, it has its
/// usual answer or none, and leaves nothing behind.
/// @param plan  `first` is set here, and `last` where only one is to fail
Outcome fail_one_by_one(const Request& request, const ForEach& for_each, Plan plan, const bool only_one,
                        const std::size_t all_up_to) {
    Outcome outcome;
    const std::optional<Answer> wanted = run(request, for_each);
    if (!wanted || std::holds_alternative<Problem>(*wanted)) ADD_FAILURE() << "it is not even answered otherwise";
    {
        const Armed counting({SIZE_MAX, SIZE_MAX, plan.least_bytes, 0});
        run(request, for_each);
        outcome.allocations = counting.count();
    }
    for (const std::size_t number : numbers(outcome.allocations, all_up_to)) {
        SCOPED_TRACE("allocation " + std::to_string(number) + " of " + std::to_string(outcome.allocations));
        plan.first = number;
        if (only_one) plan.last = number;
        std::optional<Answer> got;
        {
            const Armed armed(plan);
            got = run(request, for_each);
        }
        ++(got ? outcome.answered : outcome.refused);
        if (got) expect_same(*wanted, *got);
        if (testing::Test::HasFailure()) return outcome;
    }
    const std::optional<Answer> after = run(request, for_each);
    EXPECT_TRUE(after);
    if (after) expect_same(*wanted, *after);
    EXPECT_TRUE(memory::has_reserve());
    return outcome;
}

/// Of the formats besides an operation's first one, which does most of the same, only some fail.
std::size_t how_many(const Case& one) { return one.query.empty() ? kAllUpTo : kAllUpTo / 10; }

class Allocation : public testing::TestWithParam<Case> {};

TEST_P(Allocation, WhicheverFailsTheReserveStandsIn) {
    const Outcome outcome = fail_one_by_one(request_of(GetParam()), InOrder(), {}, true, how_many(GetParam()));
    EXPECT_GT(outcome.answered, 0U);
    EXPECT_EQ(outcome.refused, 0U);
}

TEST_P(Allocation, WhereverMemoryEndsTheReserveLetsTheRequestEnd) {
    Plan plan;
    plan.bytes_from_reserve = memory::kReserveBytes;
    EXPECT_GT(fail_one_by_one(request_of(GetParam()), InOrder(), plan, false, kAllUpTo / 10).answered, 0U);
}

TEST_P(Allocation, WhereThereIsNoRoomForWhatIsLargeTheRequestIsRefused) {
    Plan plan;
    plan.least_bytes = kLarge;
    const Outcome outcome = fail_one_by_one(request_of(GetParam()), InOrder(), plan, false, kAllUpTo);
    EXPECT_EQ(outcome.answered, 0U);
}

TEST_P(Allocation, FailsOnWorkersAsItDoesOnOneThread) {
    const Pool pool(3, 4);
    EXPECT_EQ(fail_one_by_one(request_of(GetParam()), pool.for_each(), {}, true, kAllUpTo / 10).refused, 0U);
    EXPECT_EQ(pool.stats().busy, 0);
    EXPECT_EQ(pool.stats().failed, 0U);
}

constexpr const char* kCharacter = "tests/data/characters/vroid_Sakurada_Fumiriya.chains.glb";

// What only the exact parser reads, and files, use up one half of the reserve, too, while they are parsed, if they are
// large; the other half is for letting go of them.
TEST(ParserAllocation, WhereverMemoryEndsWhatWasReadIsLetGo) {
    const std::string body = content_of("api/examples/hairstyles.json");
    std::size_t count = 0, let_go = 0;
    {
        const Armed counting;
        const auto parsed = nlohmann::json::parse(body);
        count = counting.count();
    }
    ASSERT_GT(count, 100U);
    for (std::size_t number = 0; number < count; ++number) {
        Plan plan;
        plan.first = number;
        plan.is_short_for_who_lets_go = true;
        bool has_failed = false;
        memory::hold_reserve();
        try {
            const Armed armed(plan);
            const auto parsed = nlohmann::json::parse(body);
        } catch (const std::bad_alloc&) {
            has_failed = true;
        }
        EXPECT_TRUE(has_failed) << number;
        let_go += failing::has_failed_letting_go ? 1U : 0U;
    }
    EXPECT_GT(let_go, 10U);
}

const std::vector<Case> kCases{
    {"/v1/tufts", "", "api/examples/tufts.json"},
    {"/v1/tufts", "format=gltf", "api/examples/tufts.json"},
    {"/v1/fills", "", "api/examples/fills.json"},
    {"/v1/fills", "format=glb", "api/examples/fills.json"},
    {"/v1/hairstyles", "", "api/examples/hairstyles.json"},
    {"/v1/hairstyles", "format=json", "api/examples/hairstyles.json"},
    {"/v1/hairstyles", "clip=flip_book", "api/examples/hairstyles.json"},
    {"/v1/hairstyles", "compression=meshopt", "api/examples/hairstyles.json"},
    {"/v1/motions", "", "api/examples/motions.json"},
    {"/v1/motions", "format=glb", "api/examples/motions.json"},
    {"/v1/motions", "format=xdts", "api/examples/motions.json"},
    {"/v1/motions", "format=csv", "api/examples/motions.json"},
    {"/v1/motions", "format=vmd", "api/examples/motions.json"},
    {"/v1/motions", "format=bvh", "api/examples/motions.json"},
    {"/v1/motions", "format=usda", "api/examples/motions.json"},
    {"/v1/characters/chains", "", kCharacter},
    {"/v1/characters/motion", "", kCharacter},
    {"/v1/characters/motion", "format=json", kCharacter},
    {"/v1/schedules", "", "api/examples/schedules.json"},
    {"/v1/schedules", "period=0.5", ""},
    {"/v1/evaluations", "", "api/examples/evaluations.json"},
    {"/v1/fits", "", "api/examples/fits.json"},
    {"/v1/limits", "", ""},
    {"/v1/version", "", ""},
    {"/openapi.yaml", "", ""},
    {"/docs", "", ""},
};

INSTANTIATE_TEST_SUITE_P(Operations, Allocation, testing::ValuesIn(kCases));

TEST(AllocationCases, EveryOperationHasOne) {
    for (const Route& route : routes()) {
        if (route.path.find('{') != std::string_view::npos || route.path == "/") continue;
        const auto is_tried = [&](const Case& one) { return one.path == route.path; };
        EXPECT_TRUE(std::any_of(kCases.begin(), kCases.end(), is_tried)) << route.path;
    }
}

/// What fails does so at once: no reserve stands in.
class PoolAllocation : public testing::Test {
  protected:
    PoolAllocation() : handler_(std::set_new_handler(nullptr)) {}
    ~PoolAllocation() override { std::set_new_handler(handler_); }

  private:
    std::new_handler handler_;
};

TEST_F(PoolAllocation, ALoopWhoseJobsRunOutOfMemoryEndsAndThePoolGoesOn) {
    const Pool pool(3, 4);
    for (std::size_t number = 0; number < 200; ++number) {
        bool has_failed = false;
        try {
            const Armed armed({number, number});
            pool.for_each()(64, [](const std::size_t i) { delete new std::size_t(i); });
        } catch (const std::bad_alloc&) {
            has_failed = true;
        }
        EXPECT_EQ(has_failed, number < 64) << number;
        std::atomic<int> visits = 0;
        pool.for_each()(100, [&](std::size_t) { ++visits; });
        EXPECT_EQ(visits, 100);
    }
    EXPECT_EQ(pool.stats().busy, 0);
}

TEST_F(PoolAllocation, AJobThatCannotBeQueuedIsNotRunAndTheNextOneIs) {
    Pool pool(1, 1'000);
    std::atomic<std::size_t> ran = 0;
    std::size_t accepted = 0;
    for (std::size_t number = 0; number < 40; ++number) {
        const std::vector<int> ballast(64);  // too large to fit into a std::function
        try {
            const Armed armed({0, 0});
            accepted += pool.submit([&ran, ballast] { ran += ballast.size() / 64; }) ? 1U : 0U;
        } catch (const std::bad_alloc&) {
            accepted += pool.submit([&ran, ballast] { ran += ballast.size() / 64; }) ? 1U : 0U;
        }
    }
    pool.stop();
    EXPECT_EQ(accepted, 40U);
    EXPECT_EQ(ran, accepted);
}

}  // namespace
}  // namespace tuftwave::server
