#include "service/service.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <future>
#include <latch>
#include <memory>
#include <thread>
#include <utility>

#include "support.hpp"

namespace tuftwave::server {
namespace {

LogOptions silent() {
    LogOptions options;
    options.level = "off";
    return options;
}

struct ServiceTest : testing::Test {
    Config config;
    Log log{silent()};
    Pool pool{1, 1};
    Access access{config, {}, {}};
    Service service{config, access, pool, log};

    Response admin_answer(const std::string& path) { return service.handle_admin({"GET", path, {}, {}, ""}, {}); }
    std::string admin(const std::string& path) { return admin_answer(path).body; }
};

nlohmann::json small_tufts() {
    nlohmann::json body = small_hairstyle();
    body.erase("motion");
    return body;
}

/// What a client gets for a request, once it has come.
Response ask(Service& service, const Request& request, std::stop_source stop = {}) {
    Request head = request;
    head.body.clear();
    auto verdict = service.admit(head, false);
    if (auto* early = std::get_if<Response>(&verdict)) return std::move(*early);
    const auto answered = std::make_shared<std::promise<Response>>();  // shared: it is still used when get() returns
    std::get<Admission>(verdict).answer(request, std::move(stop),
                                        [answered](Response response) { answered->set_value(std::move(response)); });
    return answered->get_future().get();
}

std::string header_of(const Response& response, const std::string& name) {
    for (const auto& [key, value] : response.headers) {
        if (key == name) return value;
    }
    return "";
}

/// Keeps a pool's only worker busy until it is destroyed.
class BusyWorker {
  public:
    explicit BusyWorker(Pool& pool) {
        EXPECT_TRUE(pool.submit([this] {
            begun_.count_down();
            released_.wait();
            ended_.count_down();
        }));
        begun_.wait();
    }
    ~BusyWorker() {
        released_.count_down();
        ended_.wait();
    }

  private:
    std::latch begun_{1}, released_{1}, ended_{1};
};

TEST_F(ServiceTest, AnswersWithoutASocket) {
    const Response response = ask(service, json_post("/v1/hairstyles", small_hairstyle().dump()));
    EXPECT_EQ(response.status, 200);
    EXPECT_EQ(response.content_type, "model/gltf-binary");
    EXPECT_EQ(header_of(response, "Request-Id").size(), 16U);
}

TEST_F(ServiceTest, GivesTheSameBytesOnAnyNumberOfWorkers) {
    nlohmann::json body = small_hairstyle();
    for (int i = 1; i < 40; ++i) {
        body["tufts"].push_back(body["tufts"][0]);
        body["tufts"].back()["points"][1][0] = 0.001 * i;
    }
    const Request request = json_post("/v1/hairstyles", body.dump());
    const Response expected = ask(service, request);
    for (const int workers : {2, 4, 16}) {
        Pool many(workers, 4);
        Service other(config, access, many, log);
        EXPECT_EQ(ask(other, request).content(), expected.content()) << workers;
    }
}

TEST_F(ServiceTest, AFullQueueSaysWhenToComeBack) {
    const BusyWorker busy(pool);
    ASSERT_TRUE(pool.submit([] {}));  // the one place in the queue
    const Response response = ask(service, json_post("/v1/tufts", "{}"));
    EXPECT_EQ(response.status, 503);
    EXPECT_EQ(header_of(response, "Retry-After"), "1");
    EXPECT_EQ(admin("/readyz"), "full\n");
    EXPECT_EQ(admin_answer("/readyz").status, 200) << "or all replicas would be taken out when all are full";
    EXPECT_EQ(ask(service, {"GET", "/v1/version", {}, {}, ""}).status, 200);  // needs no worker
}

TEST_F(ServiceTest, SmallWorkNeedsNoWorkerAndGivesTheSameBytes) {
    const Request small = json_post("/v1/tufts", small_tufts().dump());
    const auto whole = std::get<Response>(answer_to(small));
    const BusyWorker busy(pool);
    ASSERT_TRUE(pool.submit([] {}));
    const Response response = ask(service, small);
    EXPECT_EQ(response.status, 200);
    EXPECT_EQ(response.content(), whole.content());
    EXPECT_EQ(ask(service, json_post("/v1/schedules", "{}")).status, 200);
}

TEST_F(ServiceTest, ASmallBodyThatAsksForMuchNeedsAWorker) {
    const BusyWorker busy(pool);
    ASSERT_TRUE(pool.submit([] {}));
    nlohmann::json rings = small_tufts(), fine = small_tufts(), many = small_tufts();
    rings["mesh"] = {{"rings", 4'096}};
    fine["mesh"] = {{"tolerance", 1e-5}};
    for (int i = 0; i < 5; ++i) many["tufts"].push_back(many["tufts"][0]);
    for (const nlohmann::json& body : {rings, fine, many}) {
        ASSERT_LT(body.dump().size(), 1'000u);
        ASSERT_TRUE(std::holds_alternative<Response>(answer_to(json_post("/v1/tufts", body.dump())))) << body;
        EXPECT_EQ(ask(service, json_post("/v1/tufts", body.dump())).status, 503) << body;
    }
    EXPECT_EQ(ask(service, json_post("/v1/schedules", R"({"repeat": 1000})")).status, 503);
}

TEST_F(ServiceTest, WhoeverGetsNoWorkerInTimeIsToldToComeBack) {
    config.deadline_seconds = 0.01;
    Service hurried(config, access, pool, log);
    const BusyWorker busy(pool);
    EXPECT_EQ(ask(hurried, json_post("/v1/tufts", "{}")).status, 503);
}

TEST_F(ServiceTest, WorkThatRunsTooLongIsStopped) {
    config.deadline_seconds = 0.02;
    Service hurried(config, access, pool, log);
    std::ifstream example(TUFTWAVE_SOURCE_DIR "/api/examples/fits.json");
    nlohmann::json many = nlohmann::json::parse(example);
    for (int i = 0; i < 400; ++i) many["drawn"].push_back(many["drawn"][0]);  // a second
    const Request request = json_post("/v1/fits", many.dump());
    int status = 503;  // what it is if the worker itself wakes up too late
    for (int i = 0; i < 50 && status == 503; ++i) status = ask(hurried, request).status;
    EXPECT_EQ(status, 504);
}

TEST_F(ServiceTest, WorkForNobodyIsNotDone) {
    std::stop_source gone;
    gone.request_stop();
    EXPECT_EQ(ask(service, json_post("/v1/hairstyles", small_hairstyle().dump()), gone).status, 504);
}

TEST_F(ServiceTest, LargeBodyIsNotReadWhileThereIsNoRoom) {
    const BusyWorker busy(pool);
    ASSERT_TRUE(pool.submit([] {}));
    const auto verdict = [&](const std::string& length) {
        return service.admit({"POST", "/v1/tufts", {}, {{"content-length", length}}, ""}, false);
    };
    EXPECT_TRUE(std::holds_alternative<Admission>(verdict("65536")));
    ASSERT_TRUE(std::holds_alternative<Response>(verdict("1000000")));
    EXPECT_EQ(std::get<Response>(verdict("1000000")).status, 503);
}

TEST_F(ServiceTest, ABodyThatHasComeIsRefusedOnItsHeadWhileThereIsNoRoom) {
    const auto status_of = [&](const std::string& path) {
        const auto verdict = service.admit({"POST", path, {}, {{"content-length", "1000"}}, ""}, true);
        return std::holds_alternative<Response>(verdict) ? std::get<Response>(verdict).status : 0;
    };
    EXPECT_EQ(status_of("/v1/hairstyles"), 0);
    const BusyWorker busy(pool);
    ASSERT_TRUE(pool.submit([] {}));
    EXPECT_EQ(status_of("/v1/hairstyles"), 503);
    EXPECT_EQ(status_of("/v1/tufts"), 0) << "which may need no worker";
    EXPECT_TRUE(admin("/metrics").find(R"(route="/v1/hairstyles",method="POST",code="503"} 1)") != std::string::npos);
}

TEST_F(ServiceTest, IsReadyUntilItDrains) {
    EXPECT_EQ(admin("/livez"), "alive\n");
    EXPECT_EQ(admin("/readyz"), "ready\n");
    service.start_draining();
    EXPECT_EQ(admin("/readyz"), "draining\n");
    EXPECT_EQ(admin("/livez"), "alive\n");
    EXPECT_EQ(ask(service, {"GET", "/v1/version", {}, {}, ""}).status, 200);
}

TEST_F(ServiceTest, CountsByRouteTemplateAndNeverByWhatAClientSent) {
    ask(service, {"GET", "/v1/version", {}, {}, ""});
    ask(service, {"OPTIONS", "/etc/passwd", {}, {}, ""});
    const std::string metrics = admin("/metrics");
    EXPECT_NE(metrics.find("tuftwave_http_requests_total{route=\"/v1/version\",method=\"GET\",code=\"200\"} 1\n"),
              std::string::npos);
    EXPECT_NE(metrics.find("tuftwave_http_requests_total{route=\"none\",method=\"OPTIONS\",code=\"404\"} 1\n"),
              std::string::npos);
    EXPECT_EQ(metrics.find("passwd"), std::string::npos);
}

TEST_F(ServiceTest, OptionsNamesTheMethods) {
    const Response response = ask(service, {"OPTIONS", "/v1/schedules", {}, {}, ""});
    EXPECT_EQ(response.status, 204);
    EXPECT_EQ(header_of(response, "Allow"), "GET, HEAD, POST, OPTIONS");
}

TEST_F(ServiceTest, WhatIsRefusedBeforeItIsCompleteIsAProblemToo) {
    for (const int status : {400, 404, 405, 408, 411, 413, 414, 415, 417, 431, 500, 501, 503, 505}) {
        const Response response = service.refuse(status);
        EXPECT_EQ(response.status, status);
        EXPECT_EQ(response.content_type, "application/problem+json");
        EXPECT_EQ(header_of(response, "Request-Id").size(), 16U);
    }
    EXPECT_EQ(service.refuse(418).status, 400);
    EXPECT_EQ(header_of(service.refuse(503), "Retry-After"), "1");
}

}  // namespace
}  // namespace tuftwave::server
