#include "log/log.hpp"

#include <poll.h>
#include <spdlog/async_logger.h>
#include <spdlog/details/null_mutex.h>
#include <spdlog/details/thread_pool.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/base_sink.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>
#include <utility>

namespace tuftwave::server {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

constexpr auto kPatienceAtTheEnd = std::chrono::seconds(1);
constexpr int kPollMs = 50;

/// Writes whole lines to a descriptor that may be a pipe nobody reads. spdlog's own sinks would block there, and the
/// destructor of its thread pool with them.
class DescriptorSink final : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
  public:
    explicit DescriptorSink(const int descriptor) : descriptor_(descriptor) {}

    /// From now on lines that cannot be written within a second in all are dropped.
    void hurry() { give_up_at_ = (Clock::now() + kPatienceAtTheEnd).time_since_epoch().count(); }
    std::size_t dropped() const { return dropped_; }

  private:
    void sink_it_(const spdlog::details::log_msg& message) override {
        spdlog::memory_buf_t line;
        if (is_torn_) line.push_back('\n');  // what could be written of the line before stands alone
        formatter_->format(message, line);
        const char* next = line.data();
        const char* const end = next + line.size();
        while (next != end) {
            // A pipe that polls as writable takes PIPE_BUF bytes without blocking.
            const auto part = std::min<std::size_t>(static_cast<std::size_t>(end - next), PIPE_BUF);
            const ssize_t written = wait_until_writable() ? ::write(descriptor_, next, part) : -1;
            if (written < 0 && (errno == EINTR || errno == EAGAIN) && !has_given_up()) continue;
            if (written <= 0) {
                is_torn_ = is_torn_ || next != line.data();
                ++dropped_;
                return;
            }
            next += written;
        }
        is_torn_ = false;
    }
    void flush_() override {}

    bool wait_until_writable() const {
        while (!has_given_up()) {
            pollfd ready{descriptor_, POLLOUT, 0};
            if (::poll(&ready, 1, kPollMs) > 0) return true;
        }
        return false;
    }

    bool has_given_up() const { return Clock::now().time_since_epoch().count() >= give_up_at_; }

    const int descriptor_;
    bool is_torn_ = false;
    std::atomic<Clock::rep> give_up_at_{Clock::duration::max().count()};
    std::atomic<std::size_t> dropped_{0};
};

std::string_view name_of(const Log::Level level) {
    switch (level) {
        case Log::Level::kDebug:
            return "debug";
        case Log::Level::kInfo:
            return "info";
        case Log::Level::kWarn:
            return "warn";
        case Log::Level::kError:
            return "error";
    }
    return "error";
}

spdlog::level::level_enum spdlog_level(const std::string& name) {
    if (name == "debug") return spdlog::level::debug;
    if (name == "warn") return spdlog::level::warn;
    if (name == "error") return spdlog::level::err;
    if (name == "off") return spdlog::level::off;
    return spdlog::level::info;
}

/// The time in ISO 8601, UTC, with milliseconds.
std::string now_text() {
    const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(since_epoch).count();
    const auto seconds = static_cast<std::time_t>(ms / 1000);
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    std::array<char, 32> date{};
    std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%S", &utc);
    std::array<char, 8> fraction{};
    std::snprintf(fraction.data(), fraction.size(), ".%03dZ", static_cast<int>(ms % 1000));
    return std::string(date.data()) + fraction.data();
}

/// In ASCII, without control characters; bytes that are not UTF-8 become U+FFFD.
std::string escaped(const Json& value) { return value.dump(-1, ' ', true, Json::error_handler_t::replace); }

bool is_plain(const std::string& text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](const char c) {
        return c > ' ' && c < '\x7f' && c != '"' && c != '\\' && c != '=';
    });
}

/// The record's values one after the other: time, level and message bare, everything else as name=value.
std::string text_line(const Json& record) {
    std::string line;
    for (const auto& [name, value] : record.items()) {
        if (!line.empty()) line += ' ';
        if (name != "ts" && name != "level" && name != "msg") line += (is_plain(name) ? name : escaped(name)) + "=";
        const std::string* text = value.get_ptr<const std::string*>();
        line += text && (is_plain(*text) || name == "msg") && escaped(value).size() == text->size() + 2
                    ? *text
                    : escaped(value);
    }
    return line;
}

/// Microseconds are as fine as these clocks are worth reading.
double rounded(const double ms) { return std::round(ms * 1000) / 1000; }

}  // namespace

class Log::Writer {
  public:
    explicit Writer(const LogOptions& options)
        : as_text_(options.format == "text" || (options.format == "auto" && ::isatty(options.descriptor) == 1)),
          sink_(std::make_shared<DescriptorSink>(options.descriptor)),
          pool_(std::make_shared<spdlog::details::thread_pool>(options.queue_records, 1)),
          logger_(std::make_shared<spdlog::async_logger>("tuftwave", sink_, pool_,
                                                         spdlog::async_overflow_policy::overrun_oldest)) {
        logger_->set_formatter(std::make_unique<spdlog::pattern_formatter>("%v", spdlog::pattern_time_type::utc, "\n"));
        logger_->set_level(spdlog_level(options.level));
    }
    ~Writer() {
        sink_->hurry();
        pool_.reset();  // writes what is waiting and joins its thread, which then holds no logger any more
    }

    bool writes(const Level level) const { return logger_->should_log(spdlog_level(std::string(name_of(level)))); }

    Json begin(const Level level, const std::string_view message) const {
        return {{"ts", now_text()}, {"level", name_of(level)}, {"msg", message}};
    }

    void write(const Level level, const Json& record) {
        const std::string line = as_text_ ? text_line(record) : escaped(record);
        logger_->log(spdlog_level(std::string(name_of(level))), "{}", line);
    }

    std::size_t dropped() const { return pool_->overrun_counter() + sink_->dropped(); }

  private:
    const bool as_text_;
    // Shared because spdlog asks for it.
    std::shared_ptr<DescriptorSink> sink_;
    std::shared_ptr<spdlog::details::thread_pool> pool_;
    std::shared_ptr<spdlog::async_logger> logger_;
};

Log::Log(const LogOptions& options) : writer_(std::make_unique<Writer>(options)) {}

Log::~Log() = default;

void Log::request(const RequestRecord& record) {
    const Level level = record.status >= 500 ? Level::kWarn : Level::kInfo;
    if (!writer_->writes(level)) return;
    Json line = writer_->begin(level, "request");
    line["request_id"] = record.id;
    line["method"] = record.method;
    line["route"] = record.route;
    line["status"] = record.status;
    line["queue_ms"] = rounded(record.queue_ms);
    line["core_ms"] = rounded(record.core_ms);
    line["total_ms"] = rounded(record.total_ms);
    line["bytes_in"] = record.bytes_in;
    line["bytes_out"] = record.bytes_out;
    writer_->write(level, line);
}

void Log::event(const Level level, const std::string_view message, const NameValues& fields) {
    if (!writer_->writes(level)) return;
    Json line = writer_->begin(level, message);
    for (const auto& [name, value] : fields) line.emplace(name, value);  // never over ts, level or msg
    writer_->write(level, line);
}

std::size_t Log::dropped() const { return writer_->dropped(); }

}  // namespace tuftwave::server
