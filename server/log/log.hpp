#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "api/exchange.hpp"

namespace tuftwave::server {

struct LogOptions {
    std::string level = "info";   ///< debug, info, warn, error or off: the least that is written
    std::string format = "auto";  ///< json, text, or auto: text on a terminal, else JSON
    int descriptor = 2;           ///< where lines go: standard error, so that standard output has the ready line only
    std::size_t queue_records = 4096;  ///< records that may wait for a slow reader before the oldest are dropped
};

/// What is said of every request.
struct RequestRecord {
    std::string id;
    std::string method;
    std::string route;  ///< the template, e.g. "/v1/tufts", never the path as sent
    int status = 0;
    double queue_ms = 0;  ///< waiting for a worker
    double core_ms = 0;   ///< computing
    double total_ms = 0;
    std::uint64_t bytes_in = 0, bytes_out = 0;  ///< bodies
};

/// One line per record, whatever a client puts into it: JSON in ASCII, or text with everything odd escaped.
/// A reader that stalls costs records, never time: writing happens on a thread of the log's own. Thread-safe.
class Log {
  public:
    enum class Level { kDebug, kInfo, kWarn, kError };

    explicit Log(const LogOptions& options);
    /// Writes what is waiting, for at most a second.
    ~Log();
    Log(const Log&) = delete;
    Log& operator=(const Log&) = delete;

    /// At level info; warn if the status is 500 or above.
    void request(const RequestRecord& record);

    /// @param message  a constant; what varies belongs into the fields
    void event(Level level, std::string_view message, const NameValues& fields = {});

    /// Records lost because nobody read them fast enough.
    std::size_t dropped() const;

  private:
    class Writer;
    std::unique_ptr<Writer> writer_;
};

}  // namespace tuftwave::server
