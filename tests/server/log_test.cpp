#include "log/log.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cctype>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace tuftwave::server {
namespace {

/// Both ends of a pipe.
class Pipe {
  public:
    Pipe() { EXPECT_EQ(::pipe(ends_), 0); }
    ~Pipe() {
        close_reader();
        ::close(ends_[1]);
    }
    int writer() const { return ends_[1]; }
    void close_reader() {
        if (ends_[0] >= 0) ::close(ends_[0]);
        ends_[0] = -1;
    }
    /// What was written so far. The tests write less than a pipe holds.
    std::vector<std::string> lines() {
        ::fcntl(ends_[0], F_SETFL, O_NONBLOCK);
        std::stringstream text;
        char buffer[4096];
        for (ssize_t count; (count = ::read(ends_[0], buffer, sizeof buffer)) > 0;) text.write(buffer, count);
        std::vector<std::string> lines;
        for (std::string line; std::getline(text, line);) lines.push_back(line);
        return lines;
    }

  private:
    int ends_[2] = {-1, -1};
};

LogOptions options(const Pipe& pipe, const std::string& level, const std::string& format) {
    LogOptions made;
    made.level = level;
    made.format = format;
    made.descriptor = pipe.writer();
    return made;
}

// A quote, a line break, a colour code, a tab, a byte that is not UTF-8, a letter beyond ASCII, and a format string.
const std::string kHostile = "a\"b\nforged {} \x1b[31m\t\xff \xc3\xa9";

const RequestRecord kRecord{"id-1", "POST", "/v1/tufts", 200, 0.25, 1.5, 2.0001234, 12, 3456};

TEST(Log, RequestHasEveryField) {
    Pipe pipe;
    Log(options(pipe, "info", "json")).request(kRecord);
    const std::vector<std::string> lines = pipe.lines();
    ASSERT_EQ(lines.size(), 1u);
    nlohmann::json line = nlohmann::json::parse(lines[0], nullptr, false);
    ASSERT_TRUE(line.is_object()) << lines[0];
    std::string time = line.value("ts", "");
    for (char& c : time) c = std::isdigit(c) ? '0' : c;
    EXPECT_EQ(time, "0000-00-00T00:00:00.000Z");
    line.erase("ts");
    EXPECT_EQ(line, nlohmann::json({{"level", "info"},
                                    {"msg", "request"},
                                    {"request_id", "id-1"},
                                    {"method", "POST"},
                                    {"route", "/v1/tufts"},
                                    {"status", 200},
                                    {"queue_ms", 0.25},
                                    {"core_ms", 1.5},
                                    {"total_ms", 2.0},
                                    {"bytes_in", 12},
                                    {"bytes_out", 3456}}));
}

TEST(Log, HostileTextStaysOneJsonLineInAscii) {
    Pipe pipe;
    RequestRecord record = kRecord;
    record.id = kHostile;
    {
        Log log(options(pipe, "info", "json"));
        log.request(record);
        log.event(Log::Level::kWarn, kHostile, {{kHostile, kHostile}, {"msg", "not the message"}});
    }
    const std::vector<std::string> lines = pipe.lines();
    ASSERT_EQ(lines.size(), 2u);
    const std::string kept = "a\"b\nforged {} \x1b[31m\t\xef\xbf\xbd \xc3\xa9";
    for (const std::string& line : lines) {
        EXPECT_TRUE(nlohmann::json::accept(line)) << line;
        for (const char c : line) EXPECT_TRUE(c >= ' ' && c < '\x7f') << line;
    }
    EXPECT_EQ(nlohmann::json::parse(lines[0])["request_id"], kept);
    EXPECT_EQ(nlohmann::json::parse(lines[1])["msg"], kept);
    EXPECT_EQ(nlohmann::json::parse(lines[1])[kept], kept);
}

TEST(Log, TextFormIsOneLineWithoutControlCharacters) {
    Pipe pipe;
    {
        Log log(options(pipe, "info", "text"));
        log.request(kRecord);
        log.event(Log::Level::kInfo, "ready to serve", {{"address", kHostile}});
    }
    const std::vector<std::string> lines = pipe.lines();
    ASSERT_EQ(lines.size(), 2u);
    const std::size_t time = std::string("2026-01-01T00:00:00.000Z ").size();
    EXPECT_EQ(
        lines[0].substr(time),
        "info request request_id=id-1 method=POST route=/v1/tufts status=200 queue_ms=0.25 core_ms=1.5 total_ms=2.0 "
        "bytes_in=12 bytes_out=3456");
    EXPECT_EQ(lines[1].substr(time), R"(info ready to serve address="a\"b\nforged {} \u001b[31m\t\ufffd \u00e9")");
}

TEST(Log, AutoIsJsonUnlessOnATerminal) {
    Pipe pipe;
    Log(options(pipe, "info", "auto")).event(Log::Level::kInfo, "hello");
    const std::vector<std::string> lines = pipe.lines();
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(nlohmann::json::accept(lines[0])) << lines[0];
}

TEST(Log, LevelIsTheLeastThatIsWritten) {
    const std::vector<std::pair<std::string, std::size_t>> written{
        {"debug", 4}, {"info", 3}, {"warn", 2}, {"error", 1}, {"off", 0}};
    for (const auto& [level, count] : written) {
        Pipe pipe;
        {
            Log log(options(pipe, level, "json"));
            for (const auto each : {Log::Level::kDebug, Log::Level::kInfo, Log::Level::kWarn, Log::Level::kError})
                log.event(each, "said");
        }
        EXPECT_EQ(pipe.lines().size(), count) << level;
    }
}

TEST(Log, FailedRequestIsAWarning) {
    Pipe pipe;
    RequestRecord failed = kRecord;
    failed.status = 503;
    {
        Log log(options(pipe, "warn", "json"));
        log.request(kRecord);
        log.request(failed);
    }
    EXPECT_EQ(pipe.lines().size(), 1u);
}

TEST(Log, StalledReaderCostsRecordsNotTime) {
    std::signal(SIGPIPE, SIG_IGN);  // as the server does
    Pipe pipe;
    LogOptions small = options(pipe, "info", "json");
    small.queue_records = 256;
    {
        Log log(small);
        // About 1 MB, while a pipe holds 64 KiB: a blocking logger would hang here for ever.
        for (int i = 0; i < 5'000; ++i) log.request(kRecord);
        EXPECT_GT(log.dropped(), 0u);
    }  // gives up after a second, although the pipe is still full
}

/// Writes more records than wait, where none can be written, and sees each of them counted.
void expect_all_dropped(const int descriptor) {
    LogOptions made;
    made.format = "json";
    made.descriptor = descriptor;
    made.queue_records = 256;
    Log log(made);
    const std::size_t records = 5'000;
    for (std::size_t i = 0; i < records; ++i) log.request(kRecord);  // would hang here, or end the process
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (log.dropped() < records && std::chrono::steady_clock::now() < patience) std::this_thread::yield();
    EXPECT_EQ(log.dropped(), records);
}

TEST(Log, ReaderThatHasGoneCostsRecordsOnly) {
    std::signal(SIGPIPE, SIG_IGN);  // as the server does
    Pipe pipe;
    pipe.close_reader();
    expect_all_dropped(pipe.writer());
}

TEST(Log, FullDiskCostsRecordsOnly) {
    const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
    ASSERT_GE(full, 0);
    expect_all_dropped(full);
    ::close(full);
}

TEST(Log, ADescriptorThatIsClosedCostsRecordsOnly) {
    const int closed = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ASSERT_EQ(::close(closed), 0);
    expect_all_dropped(closed);
}

TEST(Log, LineThatADiskTookHalfStandsAlone) {
    std::signal(SIGXFSZ, SIG_IGN);
    std::FILE* const file = std::tmpfile();
    ASSERT_TRUE(file);
    LogOptions to_file;
    to_file.format = "json";
    to_file.descriptor = ::fileno(file);
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = 5'000;
    {
        Log log(to_file);
        ::setrlimit(RLIMIT_FSIZE, &small);
        log.event(Log::Level::kInfo, "long", {{"text", std::string(8'000, 'x')}});
        while (log.dropped() == 0) std::this_thread::yield();
        ::setrlimit(RLIMIT_FSIZE, &before);
        log.event(Log::Level::kInfo, "short");
    }
    std::rewind(file);
    std::string text(20'000, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), file));
    std::fclose(file);
    const std::size_t last = text.find('\n');
    EXPECT_GT(last, 4'000u);
    EXPECT_EQ(nlohmann::json::parse(text.substr(last), nullptr, false)["msg"], "short") << text.substr(last);
}

}  // namespace
}  // namespace tuftwave::server
