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
#include <charconv>
#include <chrono>
#include <climits>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

namespace tuftwave::server {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kPatienceAtTheEnd = std::chrono::seconds(1);
constexpr int kPollMs = 50;
constexpr auto kRest = std::chrono::milliseconds(5);

/// Writes whole lines to a descriptor that may be a pipe nobody reads. spdlog's own sinks would block there, and the
/// destructor of its thread pool with them.
class DescriptorSink final : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
  public:
    explicit DescriptorSink(const int descriptor) : descriptor_(descriptor) {}

    /// From now on lines that cannot be written within a second in all are dropped.
    void hurry() { give_up_at_ = (Clock::now() + kPatienceAtTheEnd).time_since_epoch().count(); }
    std::size_t dropped() const { return dropped_; }

    /// Waits a little behind a line if nothing waits: to be woken for each costs whoever logs more than all the rest.
    void rest_while(std::function<bool()> is_all_written) { is_all_written_ = std::move(is_all_written); }

  private:
    void sink_it_(const spdlog::details::log_msg& message) override {
        write(message);
        if (is_all_written_ && is_all_written_()) std::this_thread::sleep_for(kRest);
    }

    void write(const spdlog::details::log_msg& message) {
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
    std::function<bool()> is_all_written_;
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

spdlog::level::level_enum spdlog_level(const std::string_view name) {
    if (name == "debug") return spdlog::level::debug;
    if (name == "warn") return spdlog::level::warn;
    if (name == "error") return spdlog::level::err;
    if (name == "off") return spdlog::level::off;
    return spdlog::level::info;
}

/// In ASCII, without control characters; bytes that are not UTF-8 become U+FFFD.
std::string escaped(const std::string_view text) {
    return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

/// Whether JSON has it between quotes as it is.
bool needs_no_escape(const std::string_view text) {
    return std::all_of(text.begin(), text.end(),
                       [](const char c) { return c >= ' ' && c < '\x7f' && c != '"' && c != '\\'; });
}

bool is_plain(const std::string_view text) {
    return !text.empty() && needs_no_escape(text) && text.find_first_of(" =") == std::string_view::npos;
}

/// A record as it grows: behind the time, which spdlog writes, level and message, then the fields. As text these two
/// are bare, everything else is name=value.
class Line {
  public:
    Line(const bool as_text, const Log::Level level, const std::string_view message) : as_text_(as_text) {
        text_.reserve(kUsualBytes);
        if (as_text_) {
            text_ += name_of(level);
            text_ += ' ';
            text_ += needs_no_escape(message) ? std::string(message) : escaped(message);
        } else {
            append_quoted("level");
            text_ += ':';
            append_quoted(name_of(level));
            add("msg", message);
        }
    }

    void add(const std::string_view name, const std::string_view value) {
        begin(name);
        if (as_text_ && is_plain(value))
            text_ += value;
        else
            append_quoted(value);
    }
    void add(const std::string_view name, const std::uint64_t number) {
        begin(name);
        append(number);
    }
    /// Microseconds are as fine as these clocks are worth reading.
    void add_ms(const std::string_view name, const double ms) {
        begin(name);
        const auto us = static_cast<std::uint64_t>(std::llround(std::max(ms, 0.0) * 1000));
        append(us / 1000);
        const std::string digits = std::to_string(1000 + us % 1000);
        text_ += '.';
        text_ += std::string_view(digits).substr(1, std::max<std::size_t>(digits.find_last_not_of('0'), 1));
    }

    const std::string& end() {
        if (!as_text_) text_ += '}';
        return text_;
    }

  private:
    static constexpr std::size_t kUsualBytes = 256;

    void begin(const std::string_view name) {
        text_ += as_text_ ? ' ' : ',';
        if (as_text_ && is_plain(name))
            text_ += name;
        else
            append_quoted(name);
        text_ += as_text_ ? '=' : ':';
    }
    void append_quoted(const std::string_view text) {
        if (!needs_no_escape(text)) {
            text_ += escaped(text);
            return;
        }
        text_ += '"';
        text_ += text;
        text_ += '"';
    }
    void append(const std::uint64_t number) {
        std::array<char, 20> digits;
        text_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
    }

    const bool as_text_;
    std::string text_;
};

}  // namespace

class Log::Writer {
  public:
    explicit Writer(const LogOptions& options)
        : as_text(options.format == "text" || (options.format == "auto" && ::isatty(options.descriptor) == 1)),
          sink_(std::make_shared<DescriptorSink>(options.descriptor)),
          pool_(std::make_shared<spdlog::details::thread_pool>(options.queue_records, 1)),
          logger_(std::make_shared<spdlog::async_logger>("tuftwave", sink_, pool_,
                                                         spdlog::async_overflow_policy::overrun_oldest)) {
        sink_->rest_while([pool = pool_.get()] { return pool->queue_size() == 0; });
        logger_->set_formatter(std::make_unique<spdlog::pattern_formatter>(
            as_text ? "%Y-%m-%dT%H:%M:%S.%eZ %v" : "{\"ts\":\"%Y-%m-%dT%H:%M:%S.%eZ\",%v",
            spdlog::pattern_time_type::utc, "\n"));
        logger_->set_level(spdlog_level(options.level));
    }
    ~Writer() {
        sink_->hurry();
        pool_.reset();  // writes what is waiting and joins its thread, which then holds no logger any more
    }

    bool writes(const Level level) const { return logger_->should_log(spdlog_level(name_of(level))); }

    void write(const Level level, Line& line) { logger_->log(spdlog_level(name_of(level)), line.end()); }

    std::size_t dropped() const { return pool_->overrun_counter() + sink_->dropped(); }

    const bool as_text;

  private:
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
    Line line(writer_->as_text, level, "request");
    line.add("request_id", record.id);
    line.add("method", record.method);
    line.add("route", record.route);
    line.add("status", static_cast<std::uint64_t>(record.status));
    line.add_ms("queue_ms", record.queue_ms);
    line.add_ms("core_ms", record.core_ms);
    line.add_ms("total_ms", record.total_ms);
    line.add("bytes_in", record.bytes_in);
    line.add("bytes_out", record.bytes_out);
    writer_->write(level, line);
}

void Log::event(const Level level, const std::string_view message, const NameValues& fields) {
    if (!writer_->writes(level)) return;
    Line line(writer_->as_text, level, message);
    for (const auto& [name, value] : fields) {
        if (name != "ts" && name != "level" && name != "msg") line.add(name, value);
    }
    writer_->write(level, line);
}

std::size_t Log::dropped() const { return writer_->dropped(); }

}  // namespace tuftwave::server
