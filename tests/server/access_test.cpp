#include "access/access.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <variant>
#include <vector>

#include "access/new_key.hpp"
#include "api/routes.hpp"

namespace tuftwave::server {
namespace {

const std::string kChallenge = "Bearer realm=\"tuftwave\"";
const std::string kInvalid = kChallenge + ", error=\"invalid_token\"";

/// Two keys, the second with a rate of its own, and a clock that stands still.
class AccessTest : public testing::Test {
  protected:
    Access& access() {
        if (!access_) {
            auto keys = Keys::parse(alice_.line + "\n" + bob_.line + " 5\n");
            access_.emplace(config_, std::get<Keys>(std::move(keys)), Origins{}, now());
        }
        return *access_;
    }
    Now now() {
        return [this] { return time_; };
    }
    static Request request(const std::string& method, const std::string& path, const std::string& key = "") {
        Request made{method, path, {}, {}, ""};
        if (!key.empty()) made.headers.emplace_back("authorization", "Bearer " + key);
        return made;
    }
    static Request post(const std::string& key, const std::string& length = "10") {
        Request made = request("POST", "/v1/tufts", key);
        made.headers.emplace_back("content-length", length);
        return made;
    }
    /// The slug and the header that says more, or "admitted".
    std::string answer(const Request& request) { return text(access().admit(request)); }
    static std::string text(const std::variant<Visitor, Problem>& decided) {
        const auto* problem = std::get_if<Problem>(&decided);
        if (!problem) return "admitted";
        std::string text = slug(problem->code);
        for (const auto& [name, value] : problem->headers) text += " " + name + ": " + value;
        return text;
    }
    void use(const Request& request, const double worker_seconds, const std::uint64_t bytes = 0) {
        const auto decided = access().admit(request);
        ASSERT_TRUE(std::holds_alternative<Visitor>(decided)) << text(decided);
        access().charge(std::get<Visitor>(decided), worker_seconds, bytes);
    }

    const NewKey alice_ = new_key("alice"), bob_ = new_key("bob");
    Config config_;
    std::chrono::steady_clock::time_point time_{};

  private:
    std::optional<Access> access_;
};

TEST_F(AccessTest, EveryRouteNeedsAKeyButPages) {
    for (const Route& route : routes()) {
        const std::string method(route.method), path(route.path);
        const bool is_page = !path.starts_with("/v1/");
        EXPECT_EQ(answer(request(method, path)), is_page ? "admitted" : "unauthorized WWW-Authenticate: " + kChallenge)
            << path;
        EXPECT_EQ(answer(request(method, path, alice_.key)), "admitted") << path;
        EXPECT_EQ(answer(request("OPTIONS", path)), "admitted") << path;
    }
    EXPECT_EQ(answer(request("HEAD", "/")), "admitted");
    for (const char* path : {"/v1", "/v1/", "/v1/nothing", "/v2/tufts", "//v1/tufts", "/studio", "/Docs"})
        EXPECT_EQ(answer(request("GET", path)), "unauthorized WWW-Authenticate: " + kChallenge) << path;
    EXPECT_EQ(answer(request("POST", "/docs")), "unauthorized WWW-Authenticate: " + kChallenge);
}

TEST_F(AccessTest, TheAnswerIsTheSameWhateverIsWrongWithAKey) {
    std::string other = alice_.key;
    other.back() = other.back() == 'A' ? 'B' : 'A';
    const std::string hash = alice_.line.substr(6);
    for (const std::string& wrong : {other, alice_.key + "x", alice_.key.substr(1), hash, std::string("x"),
                                     alice_.key + " ", std::string(201, 'x'), std::string("alice")}) {
        const auto decided = access().admit(post(wrong));
        EXPECT_EQ(text(decided), "unauthorized WWW-Authenticate: " + kInvalid) << wrong;
        const auto* problem = std::get_if<Problem>(&decided);
        ASSERT_TRUE(problem);
        const Response response = to_response(*problem, "id");
        EXPECT_EQ(response.status, 401);
        for (const std::string& secret : {wrong, alice_.key, hash, std::string("alice"), std::string("bob")}) {
            if (secret.size() < 3) continue;
            EXPECT_EQ(response.body.find(secret), std::string::npos);
        }
    }
    Request twice = post(alice_.key);
    twice.headers.emplace_back("authorization", "Bearer " + alice_.key);
    EXPECT_EQ(answer(twice), "unauthorized WWW-Authenticate: " + kInvalid);
}

TEST_F(AccessTest, WithoutKeysNobodyNeedsOne) {
    Access open(config_, std::nullopt, Origins{}, now());
    EXPECT_FALSE(open.needs_keys());
    EXPECT_EQ(text(open.admit(post(""))), "admitted");
    EXPECT_EQ(text(open.admit(post("x"))), "admitted");
}

TEST_F(AccessTest, EachKeyHasAShareOfItsOwn) {
    config_.rate = 10;
    config_.burst = 100;
    use(post(alice_.key), 1.099);  // 1 as deposit, 1,099 ms
    EXPECT_EQ(answer(post(alice_.key)), "over_share Retry-After: 101");
    EXPECT_EQ(answer(request("GET", "/v1/limits", alice_.key)), "over_share Retry-After: 101");
    EXPECT_EQ(answer(request("GET", "/", alice_.key)), "admitted");
    EXPECT_EQ(answer(post(bob_.key)), "admitted");
    time_ += std::chrono::seconds(100);
    EXPECT_EQ(answer(post(alice_.key)), "over_share Retry-After: 1");
    time_ += std::chrono::seconds(1);
    EXPECT_EQ(answer(post(alice_.key)), "admitted");
}

TEST_F(AccessTest, ARateInTheFileGoesBeforeTheOption) {
    config_.rate = 10;
    config_.burst = 100;
    use(post(bob_.key), 1.099);
    EXPECT_EQ(answer(post(bob_.key)), "over_share Retry-After: 201");  // 5 units a second
}

TEST_F(AccessTest, BodiesCostByTheirAnnouncedOrReceivedLength) {
    config_.rate = 1;
    config_.burst = 10;
    use(post(alice_.key, "1310720"), 0, 1'310'720);  // 20 times 64 KiB and 1: 11 below zero, whatever came of it
    EXPECT_EQ(answer(post(alice_.key)), "over_share Retry-After: 12");
    Request chunked = request("POST", "/v1/tufts", bob_.key);
    use(chunked, 0, 1'310'720);
    EXPECT_EQ(answer(post(bob_.key)), "over_share Retry-After: 3");  // 11 / 5 s
}

TEST_F(AccessTest, ManyAtTheSameMomentPayTheirDeposits) {
    config_.rate = 1;
    config_.burst = 10;
    for (int i = 0; i < 10; ++i) EXPECT_EQ(answer(post(alice_.key)), "admitted") << i;
    EXPECT_EQ(answer(post(alice_.key)), "over_share Retry-After: 1");
}

TEST_F(AccessTest, OddLengthsAndCostsDoNoHarm) {
    config_.rate = 1;
    config_.burst = 10;
    for (const char* length : {"", "-1", "1e9", "99999999999999999999", "5,5"}) use(post(alice_.key, length), -5);
    EXPECT_EQ(answer(post(alice_.key)), "admitted");
    use(post(bob_.key, "18446744073709551615"), 0);
    EXPECT_EQ(answer(post(bob_.key)).substr(0, 10), "over_share");
}

TEST_F(AccessTest, WithoutKeysAllHaveOneShare) {
    config_.rate = 1;
    config_.burst = 1;
    Access open(config_, std::nullopt, Origins{}, now());
    EXPECT_EQ(text(open.admit(post(""))), "admitted");
    EXPECT_EQ(text(open.admit(post(alice_.key))), "over_share Retry-After: 1");
}

TEST_F(AccessTest, PreflightNeedsAPathThatExists) {
    const auto origins = Origins::parse("https://studio.example");
    const Access access(config_, std::nullopt, std::get<Origins>(origins), now());
    Request asked = request("OPTIONS", "/v1/tufts");
    EXPECT_FALSE(access.preflight(asked));
    asked.headers = {{"origin", "https://studio.example"}, {"access-control-request-method", "POST"}};
    const auto answered = access.preflight(asked);
    ASSERT_TRUE(answered);
    EXPECT_EQ(answered->status, 204);
    EXPECT_EQ(answered->headers.front(), (std::pair<std::string, std::string>("Allow", "POST, OPTIONS")));
    asked.path = "/v1/nothing";
    EXPECT_FALSE(access.preflight(asked));
}

class OpenTest : public AccessTest {
  protected:
    ~OpenTest() override { ::unlink(path_.c_str()); }
    void write_keys(const std::string& text) {
        const int descriptor = ::mkstemp(path_.data());
        ASSERT_GE(descriptor, 0);
        ASSERT_EQ(::write(descriptor, text.data(), text.size()), static_cast<ssize_t>(text.size()));
        ::close(descriptor);
        config_.key_file = path_;
    }
    static std::string error(const Config& config) {
        const auto made = Access::open(config);
        const auto* error = std::get_if<UsageError>(&made);
        return error ? error->message : "opened";
    }
    std::string path_ = testing::TempDir() + "access-XXXXXX";
};

TEST_F(OpenTest, ReadsTheKeysOfTheFile) {
    write_keys(alice_.line + "\n");
    auto made = Access::open(config_, now());
    ASSERT_TRUE(std::holds_alternative<std::unique_ptr<Access>>(made));
    Access& access = *std::get<std::unique_ptr<Access>>(made);
    EXPECT_TRUE(access.needs_keys());
    EXPECT_EQ(access.warning(), "");
    EXPECT_EQ(text(access.admit(post(alice_.key))), "admitted");
    EXPECT_EQ(text(access.admit(post(bob_.key))), "unauthorized WWW-Authenticate: " + kInvalid);
}

TEST_F(OpenTest, SaysWhatIsWrong) {
    EXPECT_EQ(error(config_), "opened");
    Config bad = config_;
    bad.origins = "*";
    EXPECT_EQ(error(bad).substr(0, 25), "option origins: number 1 ");
    bad = config_;
    bad.key_file = testing::TempDir() + "no-such-file";
    EXPECT_EQ(error(bad), "the key file cannot be read, or is longer than 1 MiB");
    write_keys(alice_.key);
    EXPECT_EQ(error(config_), "line 1 of the key file: expected NAME SHA256 [RATE]");
}

TEST_F(OpenTest, WarnsWhereStrangersNeedNoKey) {
    config_.insecure = "yes";
    config_.host = "0.0.0.0";
    const auto made = Access::open(config_);
    EXPECT_EQ(std::get<std::unique_ptr<Access>>(made)->warning(), "serving everybody without keys");
}

}  // namespace
}  // namespace tuftwave::server
