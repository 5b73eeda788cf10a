#include "service/metrics.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace tuftwave::server {
namespace {

TEST(Metrics, HistogramBucketsAreCumulativeAndEndAtTheCount) {
    Metrics metrics;
    for (const double seconds : {0.0005, 0.003, 0.003, 99.0})
        metrics.count_request("/v1/tufts", "POST", 200, seconds, 10);
    const std::string text = metrics.text({});
    const std::string name = "tuftwave_http_request_duration_seconds_bucket{route=\"/v1/tufts\",le=";
    EXPECT_NE(text.find(name + "\"0.001\"} 1\n"), std::string::npos);
    EXPECT_NE(text.find(name + "\"0.005\"} 3\n"), std::string::npos);
    EXPECT_NE(text.find(name + "\"10\"} 3\n"), std::string::npos);
    EXPECT_NE(text.find(name + "\"+Inf\"} 4\n"), std::string::npos);
    EXPECT_NE(text.find("tuftwave_http_request_duration_seconds_count{route=\"/v1/tufts\"} 4\n"), std::string::npos);
    EXPECT_NE(text.find("tuftwave_response_bytes_total 40\n"), std::string::npos);
}

TEST(Metrics, EverySampleBelongsToADescribedMetric) {
    Metrics metrics;
    metrics.count_request("none", "other", 404, 1, 0);
    std::istringstream lines(metrics.text({2, 1, 3, 8, 0.5, 0, {}}));
    std::string described;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("# HELP ")) described = line.substr(7, line.find(' ', 7) - 7);
        if (!line.starts_with("#")) {
            EXPECT_TRUE(line.starts_with(described)) << line;
        }
    }
}

TEST(Metrics, GaugesAreShownAsTheyAre) {
    const std::string text = Metrics().text({2, 1, 3, 6, 0.5, 7, {11, 12, 13, 14, 15}});
    for (const char* line :
         {"pool_workers 2", "pool_busy 1", "pool_queue_depth 3", "pool_queue_capacity 6", "pool_saturation 0.5",
          "log_lines_dropped_total 7", "connections 11", "connections_accepted_total 12",
          "connections_refused_total 13", "request_body_bytes 14", "unsent_answer_bytes 15"})
        EXPECT_NE(text.find("\ntuftwave_" + std::string(line) + "\n"), std::string::npos) << line;
}

TEST(Metrics, InFlightGoesUpAndDown) {
    Metrics metrics;
    const Metrics::InFlight first(metrics);
    { const Metrics::InFlight second(metrics); }
    EXPECT_NE(metrics.text({}).find("tuftwave_http_requests_in_flight 1\n"), std::string::npos);
}

}  // namespace
}  // namespace tuftwave::server
