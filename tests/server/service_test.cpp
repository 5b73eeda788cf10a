#include "service/service.hpp"

#include <gtest/gtest.h>

#include <latch>
#include <thread>

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
    Service service{config, pool, log};

    std::string admin(const std::string& path) { return service.handle_admin({"GET", path, {}, {}, ""}).body; }
};

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
    const Response response = service.handle(json_post("/v1/hairstyles", small_hairstyle().dump()));
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
    const std::string expected = service.handle(request).body;
    for (const int workers : {2, 4, 16}) {
        Pool many(workers, 4);
        EXPECT_EQ(Service(config, many, log).handle(request).body, expected) << workers;
    }
}

TEST_F(ServiceTest, AFullQueueSaysWhenToComeBack) {
    const BusyWorker busy(pool);
    ASSERT_TRUE(pool.submit([] {}));  // the one place in the queue
    const Response response = service.handle(json_post("/v1/tufts", "{}"));
    EXPECT_EQ(response.status, 503);
    EXPECT_EQ(header_of(response, "Retry-After"), "1");
    EXPECT_EQ(service.handle_admin({"GET", "/readyz", {}, {}, ""}).status, 503);
    EXPECT_EQ(service.handle({"GET", "/v1/version", {}, {}, ""}).status, 200);  // needs no worker
}

TEST_F(ServiceTest, WhoeverGetsNoWorkerInTimeIsToldToComeBack) {
    config.deadline_seconds = 0.01;
    Service hurried(config, pool, log);
    const BusyWorker busy(pool);
    EXPECT_EQ(hurried.handle(json_post("/v1/tufts", "{}")).status, 503);
}

TEST_F(ServiceTest, IsReadyUntilItDrains) {
    EXPECT_EQ(admin("/livez"), "alive\n");
    EXPECT_EQ(admin("/readyz"), "ready\n");
    service.start_draining();
    EXPECT_EQ(admin("/readyz"), "draining\n");
    EXPECT_EQ(admin("/livez"), "alive\n");
    EXPECT_EQ(service.handle({"GET", "/v1/version", {}, {}, ""}).status, 200);
}

TEST_F(ServiceTest, CountsByRouteTemplateAndNeverByWhatAClientSent) {
    service.handle({"GET", "/v1/version", {}, {}, ""});
    service.handle({"BREW\n", "/etc/passwd", {}, {}, ""});
    const std::string metrics = admin("/metrics");
    EXPECT_NE(metrics.find("tuftwave_http_requests_total{route=\"/v1/version\",method=\"GET\",code=\"200\"} 1\n"),
              std::string::npos);
    EXPECT_NE(metrics.find("tuftwave_http_requests_total{route=\"none\",method=\"other\",code=\"404\"} 1\n"),
              std::string::npos);
    EXPECT_EQ(metrics.find("passwd"), std::string::npos);
}

TEST_F(ServiceTest, OptionsNamesTheMethods) {
    const Response response = service.handle({"OPTIONS", "/v1/schedules", {}, {}, ""});
    EXPECT_EQ(response.status, 204);
    EXPECT_EQ(header_of(response, "Allow"), "GET, HEAD, POST, OPTIONS");
}

TEST_F(ServiceTest, WhatIsRefusedBeforeItIsCompleteIsAProblemToo) {
    for (const int status : {400, 404, 405, 408, 411, 413, 414, 415, 431, 500, 503}) {
        const Response response = service.refuse(status);
        EXPECT_EQ(response.status, status);
        EXPECT_EQ(response.content_type, "application/problem+json");
        EXPECT_EQ(header_of(response, "Request-Id").size(), 16U);
    }
    EXPECT_EQ(service.refuse(418).status, 400);
}

}  // namespace
}  // namespace tuftwave::server
